// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/LiveFigures.h>

namespace offmap::live {

namespace {

double secondsBetween(SteadyTime from, SteadyTime to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

void RecentRate::add(SteadyTime time, double amount) {
    events_.push_back({time, amount});
    while (secondsBetween(events_.front().time, time) > window_) events_.pop_front();
}

std::optional<double> RecentRate::perSecond(SteadyTime now) const {
    size_t first = 0;
    while (first < events_.size() && secondsBetween(events_[first].time, now) > window_) ++first;
    if (events_.size() - first < 2) return std::nullopt;
    const double seconds = secondsBetween(events_[first].time, events_.back().time);
    if (!(seconds > 0)) return std::nullopt;
    double amount = 0;  // what came with the first event came in the time before it
    for (size_t i = first + 1; i < events_.size(); ++i) amount += events_[i].amount;
    return amount / seconds;
}

}  // namespace offmap::live
