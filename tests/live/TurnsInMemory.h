// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/SimulatedRobot.h"

#include <offmap/live/LiveReduction.h>
#include <offmap/rawlog/FixedPose.h>

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace offmap::test {

/// A source that delivers clouds of the office one after the other, as fast as it is asked for.
class TurnsInMemory : public live::ScanSource {
 public:
    explicit TurnsInMemory(size_t turns, bool waits = true) : waits_(waits) {
        SimulatedRobot robot;
        for (size_t i = 0; i < turns; ++i) {
            turns_.push_back({robot.cloud()});
            robot.wait(0.1);
        }
    }

    std::optional<live::ArrivedTurn> next(const std::stop_token& stop) override {
        if (delivered_ == turns_.size() || stop.stop_requested()) return std::nullopt;
        const size_t number = delivered_++;
        return live::ArrivedTurn{turns_[number], number, std::chrono::steady_clock::now()};
    }
    live::SourceHealth health() const override {
        const bool ended = delivered_ == turns_.size();
        return {ended ? live::SourceState::Ended : live::SourceState::Running, {}, delivered_};
    }
    bool waits() const override { return waits_; }

 private:
    std::vector<rawlog::Turn> turns_;
    std::atomic<size_t> delivered_{0};
    bool waits_;
};

/// The office's map, and where SimulatedRobot stands in it.
inline live::LiveSetup officeSetup() {
    live::LiveSetup setup;
    setup.map = std::make_shared<core::LineMap>(mapOf(evaluation::officeRoom()));
    setup.poses = std::make_shared<rawlog::FixedPose>(mrpt::math::TPose2D(2, 2.5, 0.3), 0.02, 0.01);
    return setup;
}

}  // namespace offmap::test
