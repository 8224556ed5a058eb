// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
    /// \param along not of length 0 \param slack [m] per point, or empty
    OffsetsFromLine(const PlanePoints& points, std::span<const float> slack,
                    const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& along,
                    double length)
        : points_(points), slack_(slack), from_(from), along_(along), length_(length) {}

    /// The point that is furthest off, the first of several, if that is more than a limit [m]; else
    /// the number of points.
    uint32_t furthestBeyond(double limit) const;
    bool anyBeyond(double limit) const;

 private:
    static constexpr uint32_t blockSize = 8;
    using Block = Eigen::Array<double, blockSize, 1>;

    uint32_t count() const { return static_cast<uint32_t>(points_.size()); }
    uint32_t furthestAmong(uint32_t begin, uint32_t end, double scaledLimit) const;

    double at(uint32_t i) const {
        const double off =
            std::abs((points_.y[i] - from_.y) * along_.x - (points_.x[i] - from_.x) * along_.y);
        return slack_.empty() ? off : off - static_cast<double>(slack_[i]) * length_;
    }
    /// The greatest of the points from i on.
    double mostOfBlock(uint32_t i) const {
        const Eigen::Map<const Block> x(points_.x.data() + i), y(points_.y.data() + i);
        const Block off = ((y - from_.y) * along_.x - (x - from_.x) * along_.y).abs();
        if (slack_.empty()) return off.maxCoeff();
        const Eigen::Map<const Eigen::Array<float, blockSize, 1>> slack(slack_.data() + i);
        return (off - slack.cast<double>() * length_).maxCoeff();
    }

    PlanePoints points_;
    std::span<const float> slack_;
    mrpt::math::TPoint2D from_, along_;
    double length_;  // [m] of `along_`
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
inline uint32_t OffsetsFromLine::furthestBeyond(double limit) const {
    const uint32_t points = count();
    const double scaledLimit = limit * length_;
    if (points < blockSize) return furthestAmong(0, points, scaledLimit);
    double most = scaledLimit;
    uint32_t block = points;
    for (uint32_t i = 0;; i = std::min(i + blockSize, points - blockSize)) {
        const double ofBlock = mostOfBlock(i);
        if (ofBlock > most) {
            most = ofBlock;
            block = i;
        }
        if (i + blockSize >= points) break;
    }
    return block == points ? points : furthestAmong(block, block + blockSize, scaledLimit);
}

inline bool OffsetsFromLine::anyBeyond(double limit) const {
    const uint32_t points = count();
    const double scaledLimit = limit * length_;
    if (points < blockSize) return furthestAmong(0, points, scaledLimit) < points;
    for (uint32_t i = 0;; i = std::min(i + blockSize, points - blockSize)) {
        if (mostOfBlock(i) > scaledLimit) return true;
        if (i + blockSize >= points) return false;
    }
}

}  // namespace offmap::core
