// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RunLines.h"

#include <vector>

namespace offmap::core {

/// Puts straight runs together again that splitting parted.
class Merging {
 public:
    Merging(const RunLines& lines, std::vector<StraightRun>& straight)
        : lines_(lines), straight_(straight) {
        straight_.clear();
    }

    /// Merges the next run with those before it while one line serves both.
    void append(StraightRun last);

    /// Splitting gives the points beside a corner to one run or the other as the order has it.
    /// Moves the seams, so that each point there belongs to the line that it is nearer to.
    void settleSeams() {
        for (size_t i = 1; i < straight_.size(); ++i) settleSeam(straight_[i - 1], straight_[i]);
    }

 private:
    bool claims(const StraightRun& run, const StraightRun& other, uint32_t point) const;
    uint32_t seamOf(const StraightRun& first, const StraightRun& second) const;
    void settleSeam(StraightRun& first, StraightRun& second) const;

    const RunLines& lines_;
    std::vector<StraightRun>& straight_;
};

inline void Merging::append(StraightRun last) {
    while (!straight_.empty() && straight_.back().end == last.begin &&
           !lines_.isGap(last.begin - 1)) {
        const StraightRun& before = straight_.back();
        if (!lines_.mayBeStraight(before.begin, last.begin, last.end - 1)) break;
        Run both{before.sums, before.begin, last.end};
        both.sums += last.sums;
        const ScaledLine line = both.sums.line();
        // The smaller of the two mostly tells.
        const bool beforeIsSmaller = before.size() < last.size();
        const Run& smaller = beforeIsSmaller ? before : last;
        const Run& larger = beforeIsSmaller ? last : before;
        if (!lines_.serves(line, smaller) || !lines_.serves(line, larger)) break;
        last = {both, line};
        straight_.pop_back();
    }
    straight_.push_back(last);
}

/// Whether a point is nearer to the line of a run than to that of another.
inline bool Merging::claims(const StraightRun& run, const StraightRun& other,
                            uint32_t point) const {
    const mrpt::math::TPoint2D place = lines_.points()[point];
    return run.size() >= lines_.config().minPoints &&
           run.line.scaledSquare(place) * other.line.squaredLength <
               other.line.scaledSquare(place) * run.line.squaredLength;
}

inline uint32_t Merging::seamOf(const StraightRun& first, const StraightRun& second) const {
    uint32_t seam = first.end;
    while (seam + 1 < second.end && claims(first, second, seam)) ++seam;
    while (seam - 1 > first.begin && claims(second, first, seam - 1)) --seam;
    return seam;
}

inline void Merging::settleSeam(StraightRun& first, StraightRun& second) const {
    if (first.end != second.begin || lines_.isGap(first.end - 1)) return;
    const uint32_t seam = seamOf(first, second);
    if (seam == first.end) return;
    const bool grows = seam > first.end;
    const LineSums moved = grows ? lines_.sums(first.end, seam) : lines_.sums(seam, first.end);
    Run before{first.sums, first.begin, seam}, behind{second.sums, seam, second.end};
    (grows ? before : behind).sums += moved;
    (grows ? behind : before).sums -= moved;
    const ScaledLine ofBefore = before.sums.line(), ofBehind = behind.sums.line();
    if (!lines_.serves(ofBefore, before) || !lines_.serves(ofBehind, behind)) return;
    first = {before, ofBefore};
    second = {behind, ofBehind};
}

}  // namespace offmap::core
