// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace offmap::core {

/// How far points stand off a line, less their slack, all times the length of a vector along it:
/// that spares a division. Worked out for some points at a time.
class OffsetsFromLine {
 public:
    /// \param slack [m] per point, or empty
    OffsetsFromLine(const PlanePoints& points, std::span<const float> slack, const ScaledLine& line)
        : points_(points), slack_(slack), line_(line) {}

    /// The point that is furthest off, the first of several, if that is more than a limit [m]; else
    /// the number of points.
    uint32_t furthestBeyond(double limit) const;
    bool anyBeyond(double limit) const;

 private:
    static constexpr uint32_t blockSize = 8;
    using Block = Eigen::Array<double, blockSize, 1>;

    double most() const;
    uint32_t count() const { return static_cast<uint32_t>(points_.size()); }
    uint32_t furthestAmong(uint32_t begin, uint32_t end, double scaledLimit) const;

    double at(uint32_t i) const {
        const double off = std::abs((points_.y[i] - line_.point.y) * line_.along.x -
                                    (points_.x[i] - line_.point.x) * line_.along.y);
        return slack_.empty() ? off : off - static_cast<double>(slack_[i]) * line_.length;
    }
    /// Of the points from i on. Inlined, what is the same for all stays in registers.
    [[gnu::always_inline]] Block block(uint32_t i) const {
        const Eigen::Map<const Block> x(points_.x.data() + i), y(points_.y.data() + i);
        Block off =
            ((y - line_.point.y) * line_.along.x - (x - line_.point.x) * line_.along.y).abs();
        if (!slack_.empty()) {
            const Eigen::Map<const Eigen::Array<float, blockSize, 1>> slack(slack_.data() + i);
            off -= slack.cast<double>() * line_.length;
        }
        return off;
    }

    PlanePoints points_;
    std::span<const float> slack_;
    ScaledLine line_;
};

inline uint32_t OffsetsFromLine::furthestAmong(uint32_t begin, uint32_t end,
                                               double scaledLimit) const {
    double most = scaledLimit;
    uint32_t furthest = count();
    for (uint32_t i = begin; i < end; ++i) {
        const double off = at(i);
        if (off > most) {
            most = off;
            furthest = i;
        }
    }
    return furthest;
}

/// Blocks follow each other; the last one ends with the points, so it may overlap the one before.
inline double OffsetsFromLine::most() const {
    const uint32_t points = count();
    Block greatest = block(points - blockSize);
    for (uint32_t i = 0; i + blockSize < points; i += blockSize) greatest = greatest.max(block(i));
    return greatest.maxCoeff();
}

inline bool OffsetsFromLine::anyBeyond(double limit) const {
    const uint32_t points = count();
    const double scaledLimit = limit * line_.length;
    if (points < blockSize) return furthestAmong(0, points, scaledLimit) < points;
    return most() > scaledLimit;
}

inline uint32_t OffsetsFromLine::furthestBeyond(double limit) const {
    const uint32_t points = count();
    const double scaledLimit = limit * line_.length;
    if (points < blockSize) return furthestAmong(0, points, scaledLimit);
    const double furthest = most();
    if (!(furthest > scaledLimit)) return points;
    uint32_t i = 0;
    while (i + blockSize < points && block(i).maxCoeff() < furthest) i += blockSize;
    const uint32_t begin = std::min(i, points - blockSize);
    return furthestAmong(begin, begin + blockSize, scaledLimit);
}

}  // namespace offmap::core
