// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Series.h"

#include <cstdint>
#include <optional>

namespace offmap::window {

/// What became of one turn, as a timeline shows it.
struct TurnFigures {
    double removedShare = 0;  ///< [0, 1] of its returns
    double milliseconds = 0;  ///< [ms] that reducing took
    bool suspect = false;     ///< scan, pose and map did not fit
};

/// What became of the turns of a log so far, or of the newest ones of a live source, by number. Of
/// logs that are longer than it remembers, turns beside each other share a place.
class TurnHistory {
 public:
    static constexpr uint64_t mostRemembered = uint64_t{1} << 17;
    static constexpr uint64_t mostLive = 3000, leastLive = 300;

    /// Forgets all. \param count of the log; 0: live
    void setTurns(uint64_t count);
    void clear();
    void add(uint64_t number, const TurnFigures& figures);

    std::optional<TurnFigures> at(uint64_t number) const;

    /// The turns to be shown: from one, to before the other.
    uint64_t shownFrom() const { return from_; }
    uint64_t shownTo() const { return to_; }
    /// The turn at a share of the width of what is shown, [0, 1], clamped.
    uint64_t turnAt(double share) const;
    /// Where the middle of a turn is shown, as a share of the width, [0, 1], clamped.
    double shareOf(uint64_t number) const;
    /// That many turns further on, or back, within those shown.
    uint64_t steppedFrom(uint64_t number, int64_t steps) const;

    /// All by number of the turn, see place().
    const Series& removedShare() const { return removedShare_; }
    const Series& milliseconds() const { return milliseconds_; }
    const Series& suspects() const { return suspects_; }  ///< 1 for suspect turns, else 0
    /// Turns that share a place, at least 1.
    uint64_t turnsPerPlace() const { return turnsPerPlace_; }

 private:
    double place(uint64_t number) const;
    void showNewest(uint64_t number);

    Series removedShare_{mostRemembered}, milliseconds_{mostRemembered}, suspects_{mostRemembered};
    uint64_t turns_ = 0;  // of the log; 0: live
    uint64_t turnsPerPlace_ = 1;
    uint64_t from_ = 0, to_ = leastLive;
};

}  // namespace offmap::window
