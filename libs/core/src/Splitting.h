// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RunLines.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace offmap::core {

/// Cuts an ordered list of points, until a line serves each part.
class Splitting {
 public:
    Splitting(const RunLines& lines, std::vector<Run>& pending) : lines_(lines), pending_(pending) {
        cutAtGaps();
    }

    bool done() const { return pending_.empty(); }

    /// The first straight run of what is left. \pre not done
    StraightRun next();

 private:
    void cutAtGaps();
    uint32_t leastPoints() const { return std::max(lines_.config().minPoints, 1u); }
    ScaledLine chordOf(const Run& run) const;
    bool straysAlone(const Run& run, const LineTrial& trial) const;
    std::pair<Run, Run> split(const Run& run, const LineTrial& trial) const;
    std::pair<Run, Run> partsOf(const Run& run, uint32_t end, uint32_t begin) const;

    const RunLines& lines_;
    std::vector<Run>& pending_;  // the first one on top
};

/// Runs without gaps that are worth a look.
inline void Splitting::cutAtGaps() {
    pending_.clear();
    const double maxGap = lines_.config().maxGap;
    const bool whole = !hasGap(lines_.points(), maxGap);
    for (auto end = static_cast<uint32_t>(lines_.points().size()); end > 0;) {
        const uint32_t begin = whole ? 0 : beginOfRunWithoutGap(lines_.points(), end, maxGap);
        if (end - begin >= leastPoints()) pending_.push_back({{}, begin, end});
        end = begin;
    }
}

inline StraightRun Splitting::next() {
    Run run = pending_.back();
    pending_.pop_back();
    for (;;) {
        const LineTrial trial = lines_.tried(run);
        if (trial.serves()) return {run, trial.line};
        const auto [first, second] = split(run, trial);
        pending_.push_back(second);
        run = first;
    }
}

inline ScaledLine Splitting::chordOf(const Run& run) const {
    const mrpt::math::TPoint2D from = lines_.points()[run.begin];
    const mrpt::math::TPoint2D along = lines_.points()[run.end - 1] - from;
    const double squaredLength = along.sqrNorm();
    return squaredLength > 0 ? ScaledLine{from, along, squaredLength} : ScaledLine{from, {1, 0}, 1};
}

/// Whether the furthest point strays from the line alone, those beside it do not: by noise, then.
inline bool Splitting::straysAlone(const Run& run, const LineTrial& trial) const {
    const OffsetsFromLine offsets = lines_.offsets(run, trial.line);
    const uint32_t stray = trial.furthest;
    const auto isNear = [&](uint32_t point) {
        return !offsets.isBeyond(offsets.of(point), lines_.config().maxPointToLine);
    };
    return (stray == 0 || isNear(stray - 1)) && (stray + 1 == run.size() || isNear(stray + 1));
}

/// Splits a run that its line does not serve. If one point strays from that line alone, at it: its
/// chord has the noise of two points. The point is left out if either side of it would be a piece
/// even if it were cut once more: near an end, it may be what a floor begins with. Else at the
/// point furthest from its chord, which mostly is a corner; it begins the second part.
inline std::pair<Run, Run> Splitting::split(const Run& run, const LineTrial& trial) const {
    const auto before = [&](uint32_t point) {
        const uint32_t at = std::clamp(point, run.begin + 1, run.end - 1);
        return partsOf(run, at, at);
    };
    if (trial.outcome == LineTrial::Outcome::PointTooFar && straysAlone(run, trial)) {
        const uint32_t stray = run.begin + trial.furthest;
        const uint32_t shorter = std::min(stray - run.begin, run.end - (stray + 1));
        const bool nearAnEnd = shorter < 2 * leastPoints();
        return nearAnEnd ? before(stray) : partsOf(run, stray, stray + 1);
    }
    return before(run.begin + FurthestFromLine(lines_.offsets(run, chordOf(run))).point());
}

/// What ends at `end`, and what begins at `begin`. Where the run has sums, new ones are taken of
/// the smaller part; the larger one has the rest.
inline std::pair<Run, Run> Splitting::partsOf(const Run& run, uint32_t end, uint32_t begin) const {
    std::pair<Run, Run> parts({run.sums, run.begin, end}, {run.sums, begin, run.end});
    if (run.sums.count() == 0) return parts;
    const bool firstIsSmaller = end - run.begin < run.end - begin;
    Run& smaller = firstIsSmaller ? parts.first : parts.second;
    Run& larger = firstIsSmaller ? parts.second : parts.first;
    smaller.sums = lines_.sums(smaller.begin, smaller.end);
    larger.sums -= smaller.sums;
    if (begin > end) larger.sums -= lines_.sums(end, begin);
    return parts;
}

}  // namespace offmap::core
