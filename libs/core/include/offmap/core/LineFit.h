// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>

#include <mrpt/math/TPoint2D.h>

#include <array>
#include <cmath>
#include <cstdint>
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
    /// Squared distance of a point from the line, times the squared length.
    double scaledSquare(const mrpt::math::TPoint2D& p) const {
        const double scaled = (p.y - point.y) * along.x - (p.x - point.x) * along.y;
        return scaled * scaled;
    }
};

/// Sums over points as complex numbers z = x + iy: all that the line through them depends on. Those
/// of one origin can be added, and taken away again.
class LineSums {
 public:
    LineSums() = default;
    /// \param sums in lanes: of x, y [m], and of x^2 - y^2, x y [m^2]: real part of z^2, half its
    /// imaginary part
    LineSums(uint32_t count, const DoubleLanes& sums) : count_(count) { store(sums, sums_.data()); }

    // As a whole: what has just been written piece by piece would have to be waited for.
    LineSums(const LineSums& other) { *this = other; }
    LineSums& operator=(const LineSums& other) {
        DoubleLanes sums;
        load(other.sums_.data(), sums);
        store(sums, sums_.data());
        count_ = other.count_;
        return *this;
    }

    void add(double x, double y) {
        sums_[0] += x;
        sums_[1] += y;
        sums_[2] += x * x - y * y;
        sums_[3] += x * y;
        ++count_;
    }
    LineSums& operator+=(const LineSums& more) {
        DoubleLanes sums, others;
        load(sums_.data(), sums);
        load(more.sums_.data(), others);
        store(sums + others, sums_.data());
        count_ += more.count_;
        return *this;
    }
    LineSums& operator-=(const LineSums& less) {
        DoubleLanes sums, others;
        load(sums_.data(), sums);
        load(less.sums_.data(), others);
        store(sums - others, sums_.data());
        count_ -= less.count_;
        return *this;
    }
    uint32_t count() const { return count_; }

    /// The line of least squared distances to the points; through coinciding ones, one along x.
    /// \pre there are points
    ScaledLine line() const;

 private:
    std::array<double, doubleLaneCount> sums_{};  // written and read as a whole
    uint32_t count_ = 0;
};

inline ScaledLine LineSums::line() const {
    const double n = count_, x = sums_[0], y = sums_[1], real = sums_[2], halfImag = sums_[3];
    const mrpt::math::TPoint2D point(x / n, y / n);
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

/// Total least squares line through points that are added one by one. Sums are taken from the first
/// point, so that far from (0, 0) nothing is lost.
class LineFit {
 public:
    void add(const mrpt::math::TPoint2D& p) {
        if (count() == 0) origin_ = p;
        sums_.add(p.x - origin_.x, p.y - origin_.y);
    }
    uint32_t count() const { return sums_.count(); }

    /// See LineSums::line().
    FittedLine line() const {
        FittedLine line = sums_.line().withUnitVector();
        line.point += origin_;
        return line;
    }

 private:
    mrpt::math::TPoint2D origin_;
    LineSums sums_;
};

/// Through all of the points.
LineFit fitOf(std::span<const mrpt::math::TPoint2D> points);

}  // namespace offmap::core
