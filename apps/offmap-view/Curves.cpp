// SPDX-License-Identifier: BSD-3-Clause
#include "Curves.h"

#include <algorithm>
#include <wx/brush.h>
#include <wx/pen.h>

namespace offmap::window {

namespace {

double middleOf(const CurveBox& box, const CurveColumn& column) {
    return box.place.m_x + static_cast<double>(column.column) + 0.5;
}

/// The ground below columns that are joined.
void fillRun(wxGraphicsContext& canvas, const CurveBox& box, const CurveColumn* first,
             const CurveColumn* last, double halfWidth) {
    const double left = std::max(middleOf(box, *first) - halfWidth, box.place.m_x);
    const double right = std::min(middleOf(box, *last) + halfWidth, box.place.GetRight());
    wxGraphicsPath path = canvas.CreatePath();
    path.MoveToPoint(left, box.yOf(0));
    path.AddLineToPoint(left, box.yOf(first->high));
    for (const CurveColumn* column = first; column <= last; ++column) {
        path.AddLineToPoint(middleOf(box, *column), box.yOf(column->high));
    }
    path.AddLineToPoint(right, box.yOf(last->high));
    path.AddLineToPoint(right, box.yOf(0));
    path.CloseSubpath();
    canvas.FillPath(path);
}

}  // namespace

double CurveBox::yOf(double value) const {
    return place.GetBottom() - std::clamp(value / top, 0.0, 1.0) * place.m_height;
}

void drawCurve(wxGraphicsContext& canvas, const CurveBox& box,
               const std::vector<CurveColumn>& columns, const wxColour& colour) {
    wxGraphicsPath path = canvas.CreatePath();
    for (const CurveColumn& column : columns) {
        const double x = middleOf(box, column);
        const double low = box.yOf(column.low), high = box.yOf(column.high);
        if (column.joined) {
            path.AddLineToPoint(x, low);
        } else {
            // Long enough to be seen if it stays alone.
            path.MoveToPoint(x - 0.5, low);
            path.AddLineToPoint(x + 0.5, low);
        }
        if (high != low) path.AddLineToPoint(x, high);
    }
    canvas.SetPen(wxPen(colour, 1));
    canvas.StrokePath(path);
}

void fillCurve(wxGraphicsContext& canvas, const CurveBox& box,
               const std::vector<CurveColumn>& columns, double halfWidth, const wxColour& colour) {
    canvas.SetPen(*wxTRANSPARENT_PEN);
    canvas.SetBrush(wxBrush(colour));
    size_t begin = 0;
    for (size_t i = 1; i <= columns.size(); ++i) {
        if (i < columns.size() && columns[i].joined) continue;
        fillRun(canvas, box, &columns[begin], &columns[i - 1], halfWidth);
        begin = i;
    }
}

}  // namespace offmap::window
