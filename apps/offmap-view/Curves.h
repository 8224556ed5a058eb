// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Series.h"

#include <vector>
#include <wx/graphics.h>

namespace offmap::window {

/// Where a curve is drawn: its columns from left to right, from 0 at the bottom to a value at the
/// top.
struct CurveBox {
    wxRect2DDouble place;  ///< [px]
    double top;            ///< value at the upper edge, > 0

    double yOf(double value) const;  ///< [px] clamped to the box
};

/// A line through the greatest and least value of each column; broken where columns are not joined.
void drawCurve(wxGraphicsContext& canvas, const CurveBox& box,
               const std::vector<CurveColumn>& columns, const wxColour& colour);

/// The ground below the greatest value of each column.
/// \param halfWidth [px] that the ground goes on at either side of a gap
void fillCurve(wxGraphicsContext& canvas, const CurveBox& box,
               const std::vector<CurveColumn>& columns, double halfWidth, const wxColour& colour);

}  // namespace offmap::window
