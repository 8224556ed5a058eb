// SPDX-License-Identifier: BSD-3-Clause
#include "TurnHistory.h"

#include <algorithm>
#include <cmath>

namespace offmap::window {

void TurnHistory::setTurns(uint64_t count) {
    turns_ = count;
    turnsPerPlace_ = count / mostRemembered + 1;
    clear();
}

void TurnHistory::clear() {
    for (Series* series : {&removedShare_, &milliseconds_, &suspects_}) series->clear();
    from_ = 0;
    to_ = turns_ == 0 ? leastLive : turns_;
}

double TurnHistory::place(uint64_t number) const {
    return static_cast<double>(number - number % turnsPerPlace_);
}

void TurnHistory::add(uint64_t number, const TurnFigures& figures) {
    if (turns_ == 0) {
        showNewest(number);
    } else if (number >= turns_) {
        return;
    }
    const double where = place(number);
    removedShare_.add(where, std::clamp(figures.removedShare, 0.0, 1.0));
    milliseconds_.add(where, figures.milliseconds);
    // A place that turns share stays suspect if one of them is.
    const bool suspectAlready = turnsPerPlace_ > 1 && suspects_.at(where) == 1.0;
    suspects_.add(where, figures.suspect || suspectAlready ? 1 : 0);
}

void TurnHistory::showNewest(uint64_t number) {
    const auto newest = milliseconds_.last();
    // A source that counts from the beginning again is another run.
    if (newest && static_cast<double>(number + mostLive) < newest->place) clear();
    if (!milliseconds_.last()) {
        from_ = number;
        to_ = number + leastLive;
    }
    to_ = std::max(to_, number + 1);
    from_ = std::max(from_, to_ - std::min(to_, mostLive));
    for (Series* series : {&removedShare_, &milliseconds_, &suspects_}) {
        series->forgetBefore(static_cast<double>(from_));
    }
}

std::optional<TurnFigures> TurnHistory::at(uint64_t number) const {
    const double where = place(number);
    const auto share = removedShare_.at(where);
    const auto milliseconds = milliseconds_.at(where);
    if (!share || !milliseconds) return std::nullopt;
    return TurnFigures{*share, *milliseconds, suspects_.at(where) == 1.0};
}

uint64_t TurnHistory::turnAt(double share) const {
    const double turns = static_cast<double>(to_ - from_);
    const auto steps = static_cast<uint64_t>(std::clamp(share, 0.0, 1.0) * turns);
    return std::min(from_ + steps, to_ - 1);
}

double TurnHistory::shareOf(uint64_t number) const {
    const uint64_t shown = std::clamp(number, from_, to_ - 1);
    return (static_cast<double>(shown - from_) + 0.5) / static_cast<double>(to_ - from_);
}

uint64_t TurnHistory::steppedFrom(uint64_t number, int64_t steps) const {
    const uint64_t shown = std::clamp(number, from_, to_ - 1);
    const auto many = static_cast<uint64_t>(std::abs(steps));
    if (steps < 0) return shown - std::min(many, shown - from_);
    return shown + std::min(many, to_ - 1 - shown);
}

}  // namespace offmap::window
