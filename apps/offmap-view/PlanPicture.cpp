// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPicture.h"

#include "PixelMask.h"

#include <algorithm>
#include <memory>
#include <vector>
#include <wx/brush.h>
#include <wx/dcmemory.h>
#include <wx/image.h>
#include <wx/pen.h>

namespace offmap::window {

namespace {

constexpr double lengthOfPiece = 4;  // [px] of an arc that is drawn straight
constexpr int dotSize = 2;           // [px]
/// More than these are drawn without smooth edges: those take 2 us each.
constexpr size_t mostSmooth = 5000;

struct Stroke {
    Pixel from, to;
};

/// The walls as far as they are shown, in straight pieces.
class Strokes {
 public:
    explicit Strokes(const PlanView& view) : view_(view), shown_(view.visible()) {}

    void add(const core::Wall& wall) {
        if (!overlap(core::boundsOf(wall), shown_)) return;
        if (wall.curvature == 0) return add(wall.line);
        const double pixels = core::lengthOf(wall) * view_.scale();
        const int pieces = static_cast<int>(std::clamp(pixels / lengthOfPiece, 8.0, 500.0));
        auto before = core::placeAt(wall, 0);
        for (int i = 1; i <= pieces; ++i) {
            const auto next = core::placeAt(wall, static_cast<double>(i) / pieces);
            add({before, next});
            before = next;
        }
    }

    const std::vector<Stroke>& all() const { return strokes_; }

 private:
    void add(const mrpt::math::TSegment2D& line) {
        const auto part = clipped(line, shown_);
        if (part) strokes_.push_back({view_.toPixel(part->point1), view_.toPixel(part->point2)});
    }

    const PlanView& view_;
    const core::WallBounds shown_;
    std::vector<Stroke> strokes_;
};

void drawSmooth(wxGraphicsContext& canvas, const std::vector<Stroke>& strokes,
                const wxColour& colour) {
    canvas.SetPen(wxPen(colour, 1));
    constexpr size_t most = 500;  // the time that a path takes grows faster than its length
    for (size_t begin = 0; begin < strokes.size(); begin += most) {
        wxGraphicsPath path = canvas.CreatePath();
        for (size_t i = begin; i < std::min(begin + most, strokes.size()); ++i) {
            path.MoveToPoint(strokes[i].from.x, strokes[i].from.y);
            path.AddLineToPoint(strokes[i].to.x, strokes[i].to.y);
        }
        canvas.StrokePath(path);
    }
}

void drawMask(wxGraphicsContext& canvas, const PixelMask& mask, const wxColour& colour) {
    if (mask.empty()) return;
    wxImage image(mask.width(), mask.height(), false);
    image.SetRGB(wxRect(), colour.Red(), colour.Green(), colour.Blue());
    image.InitAlpha();
    std::copy(mask.covered().begin(), mask.covered().end(), image.GetAlpha());
    canvas.DrawBitmap(wxBitmap(image), 0, 0, mask.width(), mask.height());
}

PixelMask emptyMask(const PlanView& view) {
    return {static_cast<int>(view.width()), static_cast<int>(view.height())};
}

}  // namespace

wxBitmap pictureOfWalls(const core::LineMap& map, const PlanView& view, const wxColour& ground,
                        const wxColour& wall, double pixelsPerPixel) {
    wxBitmap picture;
    picture.CreateWithDIPSize(static_cast<int>(view.width()), static_cast<int>(view.height()),
                              pixelsPerPixel, 24);
    wxMemoryDC dc(picture);
    dc.SetBackground(wxBrush(ground));
    dc.Clear();
    const std::unique_ptr<wxGraphicsContext> canvas(wxGraphicsContext::Create(dc));
    if (!canvas) return picture;
    Strokes strokes(view);
    for (const core::Wall& each : map.walls()) strokes.add(each);
    if (strokes.all().size() <= mostSmooth) {
        drawSmooth(*canvas, strokes.all(), wall);
    } else {
        PixelMask mask = emptyMask(view);
        for (const Stroke& stroke : strokes.all()) mask.line(stroke.from, stroke.to);
        drawMask(*canvas, mask, wall);
    }
    return picture;
}

void drawDots(wxGraphicsContext& canvas, const PlanView& view,
              std::span<const mrpt::math::TPoint2D> places, const wxColour& colour) {
    PixelMask mask = emptyMask(view);
    for (const auto& place : places) mask.dot(view.toPixel(place), dotSize);
    drawMask(canvas, mask, colour);
}

}  // namespace offmap::window
