// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/WallGeometry.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TSegment2D.h>

#include <optional>

namespace offmap::window {

/// A place on a pane [px]: x to the right, y downwards, from its upper left corner.
struct Pixel {
    double x = 0, y = 0;
    bool operator==(const Pixel&) const = default;
};

/// Which part of the map a pane shows, x to the right and y upwards.
class PlanView {
 public:
    /// The place in the middle stays there. \param width, height [px] at least 1
    void setSize(double width, double height);
    /// Shows the whole rectangle with a margin; of one that is not finite, nothing changes.
    void fit(const core::WallBounds& bounds);
    /// Nearer by a factor, or further if it is less than 1; the place under the pixel stays there.
    void zoom(double factor, const Pixel& about);
    /// Moves what is shown. \param right, down [px]
    void pan(double right, double down);
    void centreOn(const mrpt::math::TPoint2D& place);

    Pixel toPixel(const mrpt::math::TPoint2D& place) const;
    mrpt::math::TPoint2D toMap(const Pixel& pixel) const;
    double scale() const { return scale_; }  ///< [px/m]
    double width() const { return width_; }
    double height() const { return height_; }
    /// What the pane shows of the map.
    core::WallBounds visible() const;

    bool operator==(const PlanView&) const = default;

 private:
    double width_ = 1, height_ = 1;      // [px]
    double scale_ = 40;                  // [px/m]
    mrpt::math::TPoint2D centre_{0, 0};  // [m] map frame
};

/// Whether two rectangles have a place in common.
bool overlap(const core::WallBounds& a, const core::WallBounds& b);

/// The part of a straight line within a rectangle, if there is one.
std::optional<mrpt::math::TSegment2D> clipped(const mrpt::math::TSegment2D& line,
                                              const core::WallBounds& bounds);

}  // namespace offmap::window
