// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <cstddef>
#include <span>

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
/// point or from a chosen origin near the points, so that far from (0, 0) nothing is lost.
class LineFit {
 public:
    /// Of points as complex numbers z = x + iy, seen from an origin: all that their line depends
    /// on.
    struct Sums {
        double x = 0, y = 0;  ///< [m] of z
        double real = 0;      ///< [m^2] of the real part of z^2, x^2 - y^2
        double halfImag = 0;  ///< [m^2] of half the imaginary part of z^2, x y

        void add(double pointX, double pointY) {
            x += pointX;
            y += pointY;
            real += pointX * pointX - pointY * pointY;
            halfImag += pointX * pointY;
        }
    };

    LineFit() = default;
    LineFit(size_t count, const mrpt::math::TPoint2D& origin, const Sums& sums)
        : count_(count), origin_(origin), sums_(sums) {}

    void add(const mrpt::math::TPoint2D& p) {
        if (count_ == 0) origin_ = p;
        ++count_;
        sums_.add(p.x - origin_.x, p.y - origin_.y);
    }
    /// As if the points of the other had been added one by one.
    void add(const LineFit& other);
    /// As if some of its points had never been added. \pre `part` has the same origin
    void remove(const LineFit& part);
    size_t count() const { return count_; }

    /// The line of least squared distances; through coinciding points, one along x.
    FittedLine line() const { return scaledLine().withUnitVector(); }
    ScaledLine scaledLine() const;

 private:
    size_t count_ = 0;
    mrpt::math::TPoint2D origin_;
    Sums sums_;
};

/// Through all of the points.
LineFit fitOf(std::span<const mrpt::math::TPoint2D> points);

inline void LineFit::add(const LineFit& other) {
    if (count_ == 0) {
        *this = other;
        return;
    }
    // (z + d)^2 = z^2 + 2 z d + d^2
    const double n = static_cast<double>(other.count_);
    const double dx = other.origin_.x - origin_.x, dy = other.origin_.y - origin_.y;
    const Sums& more = other.sums_;
    count_ += other.count_;
    sums_.x += more.x + n * dx;
    sums_.y += more.y + n * dy;
    sums_.real += more.real + 2 * (more.x * dx - more.y * dy) + n * (dx * dx - dy * dy);
    sums_.halfImag += more.halfImag + more.x * dy + more.y * dx + n * dx * dy;
}

inline void LineFit::remove(const LineFit& part) {
    count_ -= part.count_;
    sums_.x -= part.sums_.x;
    sums_.y -= part.sums_.y;
    sums_.real -= part.sums_.real;
    sums_.halfImag -= part.sums_.halfImag;
}

inline ScaledLine LineFit::scaledLine() const {
    const double n = static_cast<double>(count_);
    const auto& [x, y, real, halfImag] = sums_;
    const mrpt::math::TPoint2D point(origin_.x + x / n, origin_.y + y / n);
    // The major axis of the scatter stands at half the angle of n sum z^2 - (sum z)^2.
    const double difference = n * real - (x * x - y * y), doubled = 2 * (n * halfImag - x * y);
    const double length = std::sqrt(difference * difference + doubled * doubled);
    if (length == 0) return {point, {1, 0}, 1};
    // Half-angle formulas, from the larger component, so that neither loses digits.
    const double larger = length + std::abs(difference);
    const mrpt::math::TPoint2D along = difference >= 0 ? mrpt::math::TPoint2D(larger, doubled)
                                                       : mrpt::math::TPoint2D(doubled, larger);
    return {point, along, 2 * length * larger};
}

}  // namespace offmap::core
