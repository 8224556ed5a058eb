// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <wx/graphics.h>
#include <wx/window.h>

namespace offmap::window {

/// Where a text stands, seen from the place given.
enum class Beside : uint8_t { Right, Left, Centre };

/// The letters of axes and names in drawn panes: a little smaller than those of controls.
wxFont smallFont(const wxWindow& window);

/// [px] of a text in the canvas' present font.
wxSize extentOf(wxGraphicsContext& canvas, const std::string& text);

/// Draws a text in the canvas' present font. \param y [px] its middle
void drawText(wxGraphicsContext& canvas, const std::string& text, double x, double y,
              Beside beside = Beside::Right);

}  // namespace offmap::window
