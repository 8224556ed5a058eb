// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFrame.h>

#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace offmap::window {

/// What the timeline tells of a turn.
struct ReducedTurn {
    uint64_t number;      ///< from 0
    double removedShare;  ///< of its returns
    double milliseconds;  ///< [ms] it took to be reduced
    bool suspect;         ///< it does not fit the map
};

/// Turns on their way from the thread that reduces, which may be quick, to the timeline, which is
/// painted now and then. Any thread may use it.
class ReducedTurns {
 public:
    void add(const live::LiveFrame& frame) {
        const auto& record = frame.reduced.record;
        const auto returns = static_cast<double>(record.counts.returns);
        const double share = returns > 0 ? static_cast<double>(record.removed()) / returns : 0;
        const std::lock_guard lock(mutex_);
        turns_.push_back(
            {frame.arrived.number, share, record.milliseconds, record.health.suspect.has_value()});
    }

    /// All that were added since the last call.
    std::vector<ReducedTurn> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(turns_, {});
    }

 private:
    std::mutex mutex_;
    std::vector<ReducedTurn> turns_;
};

}  // namespace offmap::window
