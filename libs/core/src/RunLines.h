// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LaneFit.h"
#include "OffsetsFromLine.h"
#include "RunWithoutGap.h"

#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cstdint>

namespace offmap::core {

using Run = SplitAndMergeScratch::Run;
using StraightRun = SplitAndMergeScratch::StraightRun;

/// What came of fitting a line to a run. No optionals: the compiler would not keep what is in them
/// out of memory.
struct LineTrial {
    enum class Outcome {
        Serves,
        PointTooFar,  ///< from the line
        NotStraight   ///< as a glance tells; there is no line
    };
    Outcome outcome;
    ScaledLine line{};
    uint32_t furthest = 0;  ///< point of the run, if one is too far

    bool serves() const { return outcome == Outcome::Serves; }
};

/// Points, how far each may be off a line, and lines through runs of them.
class RunLines {
 public:
    RunLines(const PlanePoints& points, const SplitAndMergeConfig& config)
        : points_(points), config_(config), squaredHeight_(squaredHeightOf(config)) {}

    const PlanePoints& points() const { return points_; }
    const SplitAndMergeConfig& config() const { return config_; }

    bool isGap(uint32_t before) const { return isGapBehind(points_, before, config_.maxGap); }
    LineSums sums(uint32_t begin, uint32_t end) const { return sumsOf(points_.range(begin, end)); }

    /// How far a run's points are off a line.
    OffsetsFromLine offsets(const Run& run, const ScaledLine& line) const {
        const auto& slack = config_.slack;
        return {points_.range(run.begin, run.end),
                slack.empty() ? slack : slack.subspan(run.begin, run.size()), line};
    }
    bool serves(const ScaledLine& line, const Run& run) const {
        return !offsets(run, line).anyBeyond(config_.maxPointToLine);
    }
    bool mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const;

    /// Whether the line of its own serves a run, which gets its sums.
    LineTrial tried(Run& run) const;

 private:
    static float squaredHeightOf(const SplitAndMergeConfig& config) {
        constexpr double rounding = 1 + 1e-3;  // of points within 100 m
        const double height = 2 * rounding * config.maxPointToLine;
        return static_cast<float>(height * height);
    }

    const PlanePoints& points_;
    const SplitAndMergeConfig& config_;
    float squaredHeight_;  // [m^2] of three points that one line serves
};

/// Three points that one line serves form a triangle no higher than twice the tolerance: most
/// corners are told so, without a fit.
inline bool RunLines::mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const {
    if (!config_.slack.empty()) return true;
    const mrpt::math::TPoint2Df a = points_.asFloats(first);
    const mrpt::math::TPoint2Df toBetween = points_.asFloats(between) - a;
    const mrpt::math::TPoint2Df toLast = points_.asFloats(last) - a;
    const float twiceArea = toBetween.x * toLast.y - toBetween.y * toLast.x;
    const float fromFirst = std::max(toBetween.sqrNorm(), toLast.sqrNorm());
    const float longest = std::max(fromFirst, (toLast - toBetween).sqrNorm());
    return twiceArea * twiceArea <= squaredHeight_ * longest;
}

inline LineTrial RunLines::tried(Run& run) const {
    using enum LineTrial::Outcome;
    const bool few = run.size() <= 2;
    if (!few && !mayBeStraight(run.begin, run.begin + run.size() / 2, run.end - 1)) {
        return {NotStraight};
    }
    if (run.sums.count() == 0) run.sums = sums(run.begin, run.end);
    const ScaledLine line = run.sums.line();
    if (few) return {Serves, line};
    const FurthestFromLine furthest(offsets(run, line));
    if (!furthest.isBeyond(config_.maxPointToLine)) return {Serves, line};
    return {PointTooFar, line, furthest.point()};
}

}  // namespace offmap::core
