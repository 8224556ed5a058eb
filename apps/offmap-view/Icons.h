// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <wx/bmpbndl.h>
#include <wx/colour.h>

namespace offmap::window {

enum class Icon : uint8_t { Open, Map, Live, First, Back, Play, Pause, Forward, Theme };

/// \param colour of its lines; sharp at any resolution of the screen
wxBitmapBundle iconOf(Icon icon, const wxColour& colour);

}  // namespace offmap::window
