// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PlanView.h"

#include <offmap/core/LineMap.h>

#include <span>
#include <wx/bitmap.h>
#include <wx/colour.h>
#include <wx/graphics.h>

namespace offmap::window {

/// The walls that the view shows, on a ground of one colour.
/// \param pixelsPerPixel of the screen, for each of the view
wxBitmap pictureOfWalls(const core::LineMap& map, const PlanView& view, const wxColour& ground,
                        const wxColour& wall, double pixelsPerPixel);

/// Dots of two pixels on what is drawn already, many at little cost.
/// \param places [m] map frame
void drawDots(wxGraphicsContext& canvas, const PlanView& view,
              std::span<const mrpt::math::TPoint2D> places, const wxColour& colour);

}  // namespace offmap::window
