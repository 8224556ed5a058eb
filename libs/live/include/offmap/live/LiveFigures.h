// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ScanSource.h>
#include <offmap/rawlog/ReductionTotals.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace offmap::live {

/// How a running reduction is going.
struct LiveFigures {
    SourceHealth source;
    uint64_t turnsDropped = 0;  ///< because reducing was too slow
    size_t turnsWaiting = 0;
    rawlog::ReductionTotals totals;     ///< of all turns that were reduced
    rawlog::DurationHistogram latency;  ///< [ms] from the arrival of a turn to its result
    std::optional<double> turnsPerSecond, pointsPerSecond;  ///< lately; none before two turns
};

/// How often something happens, of late.
class RecentRate {
 public:
    /// \param window [s] that counts as lately
    explicit RecentRate(double window = 2) : window_(window) {}

    void add(SteadyTime time, double amount);
    /// [1/s] none unless something happened twice within the window before
    std::optional<double> perSecond(SteadyTime now) const;

 private:
    struct Event {
        SteadyTime time;
        double amount;
    };
    double window_;
    std::deque<Event> events_;
};

}  // namespace offmap::live
