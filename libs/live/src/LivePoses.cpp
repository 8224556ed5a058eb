// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/LivePoses.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace offmap::live {

LivePoses::LivePoses(double maxAge)
    : maxAge_(maxAge),
      track_(std::make_shared<rawlog::PoseTrack>(std::vector<rawlog::StampedPose>(), maxAge)) {}

rawlog::PoseLookup LivePoses::at(mrpt::Clock::time_point time) const {
    std::shared_ptr<const rawlog::PoseTrack> track;
    {
        const std::lock_guard lock(mutex_);
        track = track_;
    }
    return track->at(time);
}

rawlog::SettledPoses LivePoses::settled() const {
    const std::lock_guard lock(mutex_);
    const auto newest = track_->end();
    return {newest.value_or(mrpt::Clock::time_point::min()), outOfOrder_};
}

void LivePoses::add(const rawlog::StampedPose& pose) {
    const std::chrono::duration<double> remembered(std::max(10.0, 10 * maxAge_));
    const std::lock_guard lock(mutex_);
    ++added_;
    const auto newest = track_->end();
    if (newest && pose.time < *newest) ++outOfOrder_;
    poses_.push_back(pose);
    while (pose.time - poses_.front().time > remembered) poses_.pop_front();
    track_ = std::make_shared<rawlog::PoseTrack>(
        std::vector<rawlog::StampedPose>(poses_.begin(), poses_.end()), maxAge_);
}

uint64_t LivePoses::added() const {
    const std::lock_guard lock(mutex_);
    return added_;
}

}  // namespace offmap::live
