// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/SweepTurns.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace offmap::rawlog {

/// Collects the columns of one turned 2D scanner into turns. A scanner is never stopped just at the
/// end of its turn: the few columns that overlap at the end of a log or before a pause are no turn
/// of their own and stay with the turn before, which is why a turn waits for the first columns of
/// the next. \tparam Column what is remembered of a scan
template <class Column>
class TurnCollector {
 public:
    using Columns = std::vector<Column>;

    explicit TurnCollector(const SensorConfig& config) : turns_(config) {}

    /// Takes the next column. \return turns that are now known to be complete, in their order
    std::vector<Columns> add(const mrpt::obs::CObservation2DRangeScan& scan, Column column) {
        std::vector<Columns> complete;
        if (turns_.startsNewTurn(scan)) {
            if (turns_.wrapped()) {
                if (!waiting_.empty()) complete.push_back(std::exchange(waiting_, {}));
                waiting_ = std::exchange(open_, {});
            } else {
                complete = takeAll();
            }
        }
        open_.push_back(std::move(column));
        if (!waiting_.empty() && !isRemainder()) complete.push_back(std::exchange(waiting_, {}));
        return complete;
    }

    /// Ends the last turn, as a pause or the end of the log does.
    std::vector<Columns> finish() {
        turns_.reset();
        return takeAll();
    }

    bool empty() const { return open_.empty(); }
    const Column& latest() const { return open_.back(); }

 private:
    /// So few columns that they are what a scanner turns too far, not a turn that was broken off.
    bool isRemainder() const { return open_.size() * 50 < waiting_.size(); }

    std::vector<Columns> takeAll() {
        if (!waiting_.empty() && isRemainder()) {
            waiting_.insert(waiting_.end(), open_.begin(), open_.end());
            open_.clear();
        }
        std::vector<Columns> all;
        for (Columns* turn : {&waiting_, &open_}) {
            if (!turn->empty()) all.push_back(std::exchange(*turn, {}));
        }
        return all;
    }

    SweepTurns turns_;
    Columns waiting_;  // a turn that went full circle
    Columns open_;     // the one that is going on
};

}  // namespace offmap::rawlog
