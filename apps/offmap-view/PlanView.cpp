// SPDX-License-Identifier: BSD-3-Clause
#include "PlanView.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace offmap::window {

namespace {

constexpr double marginShare = 0.06;  // of the pane, on each side of what is to fit
/// [px/m] Earth in a pane; a millimetre as wide as a finger.
constexpr double leastScale = 1e-5, greatestScale = 2e4;
constexpr double leastExtent = 1;  // [m] of what is to fit: a single place has none
constexpr double furthest = 1e9;   // [m] from the origin: beyond, pixels cannot be told apart

}  // namespace

void PlanView::setSize(double width, double height) {
    width_ = std::max(width, 1.0);
    height_ = std::max(height, 1.0);
}

void PlanView::fit(const core::WallBounds& bounds) {
    const double wide = std::max(bounds.high.x - bounds.low.x, leastExtent);
    const double high = std::max(bounds.high.y - bounds.low.y, leastExtent);
    if (!std::isfinite(wide) || !std::isfinite(high)) return;
    const double room = 1 - 2 * marginShare;
    scale_ = std::clamp(room * std::min(width_ / wide, height_ / high), leastScale, greatestScale);
    centreOn((bounds.low + bounds.high) * 0.5);
}

void PlanView::zoom(double factor, const Pixel& about) {
    if (!(factor > 0) || !std::isfinite(factor)) return;
    const auto place = toMap(about);
    scale_ = std::clamp(scale_ * factor, leastScale, greatestScale);
    const auto moved = toMap(about);
    centreOn(centre_ + (place - moved));
}

void PlanView::pan(double right, double down) {
    centreOn({centre_.x - right / scale_, centre_.y + down / scale_});
}

void PlanView::centreOn(const mrpt::math::TPoint2D& place) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return;
    centre_ = {std::clamp(place.x, -furthest, furthest), std::clamp(place.y, -furthest, furthest)};
}

Pixel PlanView::toPixel(const mrpt::math::TPoint2D& place) const {
    return {0.5 * width_ + (place.x - centre_.x) * scale_,
            0.5 * height_ - (place.y - centre_.y) * scale_};
}

mrpt::math::TPoint2D PlanView::toMap(const Pixel& pixel) const {
    return {centre_.x + (pixel.x - 0.5 * width_) / scale_,
            centre_.y - (pixel.y - 0.5 * height_) / scale_};
}

core::WallBounds PlanView::visible() const { return {toMap({0, height_}), toMap({width_, 0})}; }

bool overlap(const core::WallBounds& a, const core::WallBounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

std::optional<mrpt::math::TSegment2D> clipped(const mrpt::math::TSegment2D& line,
                                              const core::WallBounds& bounds) {
    // Liang and Barsky: what each side of the rectangle leaves of the way from 0 to 1.
    const auto way = line.point2 - line.point1;
    struct Side {
        double outwards;  // how the way runs through the side
        double inside;    // how far inside its first end lies
    };
    const std::array<Side, 4> sides{
        Side{-way.x, line.point1.x - bounds.low.x}, Side{way.x, bounds.high.x - line.point1.x},
        Side{-way.y, line.point1.y - bounds.low.y}, Side{way.y, bounds.high.y - line.point1.y}};
    double from = 0, to = 1;
    for (const Side& side : sides) {
        if (side.outwards < 0) {
            from = std::max(from, side.inside / side.outwards);
        } else if (side.outwards > 0) {
            to = std::min(to, side.inside / side.outwards);
        } else if (!(side.inside >= 0)) {
            return std::nullopt;
        }
    }
    if (!(from <= to)) return std::nullopt;
    return mrpt::math::TSegment2D(line.point1 + way * from, line.point1 + way * to);
}

}  // namespace offmap::window
