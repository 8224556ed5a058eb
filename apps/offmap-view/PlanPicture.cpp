// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPicture.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_set>
#include <vector>
#include <wx/dcmemory.h>
#include <wx/image.h>

namespace offmap::window {

namespace {

/// [px] Strokes with the same ends to within this look the same, and are drawn once.
constexpr double resolution = 0.5;
constexpr double lengthOfPiece = 4;  // [px] of an arc that is drawn straight
constexpr int dotSize = 2;           // [px]

/// Gathers strokes and leaves out those that others hide.
class StrokePath {
 public:
    StrokePath(wxGraphicsContext& canvas, const PlanView& view)
        : canvas_(canvas), path_(canvas.CreatePath()), view_(view), shown_(view.visible()) {}

    void add(const mrpt::math::TSegment2D& line) {
        const auto part = clipped(line, shown_);
        if (!part) return;
        const Pixel a = rounded(view_.toPixel(part->point1));
        const Pixel b = rounded(view_.toPixel(part->point2));
        if (!drawn_.insert(keyOf(a, b)).second) return;
        path_.MoveToPoint(a.x, a.y);
        // A wall shorter than a pixel is still a wall.
        path_.AddLineToPoint(a == b ? b.x + resolution : b.x, b.y);
        constexpr size_t most = 1000;  // the time that a path takes grows faster than its length
        if (++gathered_ == most) stroke();
    }

    void stroke() {
        canvas_.StrokePath(path_);
        path_ = canvas_.CreatePath();
        gathered_ = 0;
    }

 private:
    static Pixel rounded(const Pixel& pixel) {
        return {resolution * std::round(pixel.x / resolution),
                resolution * std::round(pixel.y / resolution)};
    }

    /// 16 bits for each coordinate, which is 32,768 pixels.
    static uint64_t keyOf(const Pixel& a, const Pixel& b) {
        uint64_t key = 0;
        for (const double value : {a.x, a.y, b.x, b.y}) {
            key = key << 16 | static_cast<uint16_t>(std::lround(value / resolution));
        }
        return key;
    }

    wxGraphicsContext& canvas_;
    wxGraphicsPath path_;
    const PlanView& view_;
    const core::WallBounds shown_;
    std::unordered_set<uint64_t> drawn_;
    size_t gathered_ = 0;
};

void addWall(StrokePath& path, const core::Wall& wall, double scale) {
    if (wall.curvature == 0) return path.add(wall.line);
    const double pixels = core::lengthOf(wall) * scale;
    const int pieces = static_cast<int>(std::clamp(pixels / lengthOfPiece, 1.0, 500.0));
    auto before = core::placeAt(wall, 0);
    for (int i = 1; i <= pieces; ++i) {
        const auto next = core::placeAt(wall, static_cast<double>(i) / pieces);
        path.add({before, next});
        before = next;
    }
}

/// Which pixels of a view dots cover.
struct DotMask {
    int left = 0, top = 0, width = 0, height = 0;  // [px]
    std::vector<uint8_t> covered;                  // row by row: 0 or 255
};

DotMask maskOf(const PlanView& view, std::span<const mrpt::math::TPoint2D> places) {
    std::vector<wxPoint> dots;
    for (const auto& place : places) {
        const Pixel pixel = view.toPixel(place);
        const bool shown =
            pixel.x >= 0 && pixel.y >= 0 && pixel.x < view.width() && pixel.y < view.height();
        if (shown) dots.emplace_back(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    }
    DotMask mask;
    if (dots.empty()) return mask;
    const auto byX = [](const wxPoint& a, const wxPoint& b) { return a.x < b.x; };
    const auto byY = [](const wxPoint& a, const wxPoint& b) { return a.y < b.y; };
    const auto [left, right] = std::minmax_element(dots.begin(), dots.end(), byX);
    const auto [top, bottom] = std::minmax_element(dots.begin(), dots.end(), byY);
    mask = {left->x, top->y, right->x - left->x + dotSize, bottom->y - top->y + dotSize, {}};
    mask.covered.assign(static_cast<size_t>(mask.width) * static_cast<size_t>(mask.height), 0);
    for (const wxPoint& dot : dots) {
        for (int row = 0; row < dotSize; ++row) {
            const auto begin = mask.covered.begin() +
                               static_cast<std::ptrdiff_t>(dot.y - mask.top + row) * mask.width +
                               (dot.x - mask.left);
            std::fill_n(begin, dotSize, uint8_t{255});
        }
    }
    return mask;
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
    canvas->SetPen(wxPen(wall, 1));
    StrokePath path(*canvas, view);
    const core::WallBounds shown = view.visible();
    for (const core::Wall& each : map.walls()) {
        if (overlap(core::boundsOf(each), shown)) addWall(path, each, view.scale());
    }
    path.stroke();
    return picture;
}

void drawDots(wxGraphicsContext& canvas, const PlanView& view,
              std::span<const mrpt::math::TPoint2D> places, const wxColour& colour) {
    const DotMask mask = maskOf(view, places);
    if (mask.covered.empty()) return;
    wxImage image(mask.width, mask.height, false);
    image.SetRGB(wxRect(), colour.Red(), colour.Green(), colour.Blue());
    image.InitAlpha();
    std::copy(mask.covered.begin(), mask.covered.end(), image.GetAlpha());
    canvas.DrawBitmap(wxBitmap(image), mask.left, mask.top, mask.width, mask.height);
}

}  // namespace offmap::window
