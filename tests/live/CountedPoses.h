// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseSource.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace offmap::test {

/// Counts how often a pose is asked for: once for each column that is taken in.
class CountedPoses : public rawlog::PoseSource {
 public:
    explicit CountedPoses(std::shared_ptr<const rawlog::PoseSource> poses)
        : poses_(std::move(poses)) {}

    rawlog::PoseLookup at(mrpt::Clock::time_point time) const override {
        ++lookups_;
        return poses_->at(time);
    }
    rawlog::SettledPoses settled() const override { return poses_->settled(); }

    size_t lookups() const { return lookups_; }
    /// Whether they became so many before it took too long.
    bool waitFor(size_t lookups) const {
        const auto begin = std::chrono::steady_clock::now();
        while (lookups_ < lookups &&
               std::chrono::steady_clock::now() < begin + std::chrono::seconds(10))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return lookups_ >= lookups;
    }

 private:
    std::shared_ptr<const rawlog::PoseSource> poses_;
    mutable std::atomic<size_t> lookups_ = 0;
};

}  // namespace offmap::test
