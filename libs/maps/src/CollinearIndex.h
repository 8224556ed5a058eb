// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace offmap::maps {

/// A straight line of a drawing, its ends in the order of their coordinates.
struct DrawnLine {
    mrpt::math::TPoint2D a, b;  ///< [m]
    size_t place;               ///< of the first wall that it stands for

    DrawnLine(const mrpt::math::TPoint2D& end1, const mrpt::math::TPoint2D& end2, size_t place);

    double length() const { return (b - a).norm(); }
    double direction() const;  ///< [rad] -pi/2 ... pi/2
};

/// By its ends alone, a before b.
bool isBefore(const DrawnLine& one, const DrawnLine& other);

/// [rad] Between two lines whichever way they go, 0 ... pi/2.
double angleBetween(const DrawnLine& one, const DrawnLine& other);

/// Finds lines that lie on one line: sorted by direction, so that boxes around them are slim, and
/// the work does not grow with the length of slanted lines.
class CollinearIndex {
 public:
    /// [rad] Lines at larger angles are not found.
    static constexpr double largestAngle = 0.5 * 3.14159265358979323846 / 180;

    explicit CollinearIndex(std::span<const DrawnLine> lines);
    ~CollinearIndex();
    CollinearIndex(CollinearIndex&&) noexcept;

    /// Tells all lines, itself too, that come within margin of one of them and go its way, and
    /// perhaps more. \param margin [m]
    void near(const DrawnLine& line, double margin,
              const std::function<void(uint32_t)>& tell) const;

 private:
    struct Sector;
    std::vector<Sector> sectors_;
};

}  // namespace offmap::maps
