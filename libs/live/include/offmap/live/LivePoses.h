// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseSource.h>
#include <offmap/rawlog/PoseTrack.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

namespace offmap::live {

/// Poses that come while they are used: the newest ones, as PoseTrack interpolates them. Any thread
/// may use it.
class LivePoses : public rawlog::PoseSource {
 public:
    /// \param maxAge [s] as of PoseTrack; poses that are older than the newest by more than ten
    /// times as much, and by more than 10 s, are forgotten
    explicit LivePoses(double maxAge);

    rawlog::PoseLookup at(mrpt::Clock::time_point time) const override;
    /// Until the newest pose, if they come in their order; one that does not changes those before.
    rawlog::SettledPoses settled() const override;
    void add(const rawlog::StampedPose& pose);
    uint64_t added() const;

 private:
    const double maxAge_;  // [s]
    mutable std::mutex mutex_;
    std::deque<rawlog::StampedPose> poses_;
    std::shared_ptr<const rawlog::PoseTrack> track_;
    uint64_t added_ = 0, outOfOrder_ = 0;
};

}  // namespace offmap::live
