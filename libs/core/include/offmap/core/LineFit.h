// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PlanePoints.h>

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

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

/// The same, but for the length of the vector: that spares a root and a division.
struct ScaledLine {
    mrpt::math::TPoint2D point;
    mrpt::math::TPoint2D along;
    double squaredLength;  ///< of `along`, not 0

    FittedLine withUnitVector() const { return {point, along * (1 / std::sqrt(squaredLength))}; }
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
    /// As if the points of the other had been added one by one.
    void add(const LineFit& other);
    size_t count() const { return count_; }

    /// The line of least squared distances; through coinciding points, one along x.
    FittedLine line() const;
    ScaledLine scaledLine() const;

 private:
    friend class RangeFits;

    size_t count_ = 0;
    mrpt::math::TPoint2D origin_;
    double x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

/// Through all of the points.
LineFit fitOf(std::span<const mrpt::math::TPoint2D> points);

inline ScaledLine LineFit::scaledLine() const {
    const double n = static_cast<double>(count_);
    const mrpt::math::TPoint2D point(origin_.x + x_ / n, origin_.y + y_ / n);
    const double sxx = n * xx_ - x_ * x_, sxy = n * xy_ - x_ * y_, syy = n * yy_ - y_ * y_;
    // The major axis of the 2x2 scatter [sxx sxy; sxy syy] stands at half the angle of
    // (sxx - syy, 2 sxy).
    const double difference = sxx - syy, doubled = 2 * sxy;
    const double length = std::sqrt(difference * difference + doubled * doubled);
    if (length == 0) return {point, {1, 0}, 1};
    // Half-angle formulas, from the larger component, so that neither loses digits.
    const double larger = length + std::abs(difference);
    const mrpt::math::TPoint2D along = difference >= 0 ? mrpt::math::TPoint2D(larger, doubled)
                                                       : mrpt::math::TPoint2D(doubled, larger);
    return {point, along, 2 * length * larger};
}

/// The fits of all ranges of a list of points, each had in constant time from running sums.
class RangeFits {
 public:
    void build(const PlanePoints& points);

    /// \pre begin < end
    LineFit of(size_t begin, size_t end) const;

 private:
    struct Sums {
        double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    };
    mrpt::math::TPoint2D origin_;
    std::vector<Sums> before_;  // each point, and the end
};

}  // namespace offmap::core
