// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PlanePoints.h>

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <cstddef>

namespace offmap::core {

/// A line of the plane: a point on it and its unit direction.
struct FittedLine {
    mrpt::math::TPoint2D point;
    mrpt::math::TPoint2D direction;

    /// Coordinate of a point along the line, from `point`.
    double along(const mrpt::math::TPoint2D& p) const {
        return (p.x - point.x) * direction.x + (p.y - point.y) * direction.y;
    }
    /// Distance of a point from the line, without sign.
    double distance(const mrpt::math::TPoint2D& p) const {
        return std::abs((p.y - point.y) * direction.x - (p.x - point.x) * direction.y);
    }
    mrpt::math::TPoint2D at(double coordinate) const { return point + direction * coordinate; }
};

/// Total least squares line through points that are added one by one. Sums are taken from the first
/// point, so that far from the origin nothing is lost.
class LineFit {
 public:
    void add(const mrpt::math::TPoint2D& p) {
        if (count_ == 0) origin_ = p;
        ++count_;
        const double x = p.x - origin_.x, y = p.y - origin_.y;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
        yy_ += y * y;
    }
    /// As if the points had been added one by one, but for rounding.
    void add(const PlanePoints& points);
    /// As if the points of the other had been added one by one.
    void add(const LineFit& other);
    size_t count() const { return count_; }

    /// The line of least squared distances; through coinciding points, one along x.
    FittedLine line() const;

 private:
    size_t count_ = 0;
    mrpt::math::TPoint2D origin_;
    double x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

}  // namespace offmap::core
