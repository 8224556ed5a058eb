// SPDX-License-Identifier: BSD-3-Clause
#include "GrabberIntake.h"

#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/ShortReason.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <utility>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

GrabberIntake::GrabberIntake(rawlog::Config config, std::shared_ptr<LivePoses> poses,
                             std::string poseLabel, std::chrono::milliseconds stallsAfter,
                             const std::vector<std::string>& sections)
    : config_(std::move(config)),
      poses_(std::move(poses)),
      poseLabel_(std::move(poseLabel)),
      stallsAfter_(stallsAfter),
      assembler_(config_) {
    for (const std::string& section : sections) sensors_[section];
}

void GrabberIntake::take(const Observations& observations) {
    if (observations.empty()) return;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [time, object] : observations) {
            const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object);
            if (obs) take(obs);
        }
    }
    changed_.notify_all();
}

void GrabberIntake::take(const mrpt::obs::CObservation::Ptr& obs) {
    const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(obs.get());
    if (pose && poses_ && (poseLabel_.empty() || poseLabel_ == obs->sensorLabel)) {
        poses_->add(rawlog::stampedPose(*pose));
    }
    constexpr size_t mostWaiting = 16;
    for (rawlog::PlacedTurn& placed : assembler_.add(obs, 0)) {
        if (turns_.size() == mostWaiting) {
            turns_.pop_front();
            ++dropped_;
        }
        lastTurn_ = Steady::now();
        silent_ = false;
        turns_.push_back({std::move(placed.turn), assembled_++, lastTurn_});
    }
}

void GrabberIntake::works(const std::string& section) {
    const std::lock_guard lock(mutex_);
    sensors_[section] = {true, {}};
}

void GrabberIntake::fails(const std::string& section, const std::string& why) {
    const std::lock_guard lock(mutex_);
    Sensor& sensor = sensors_[section];
    if (sensor.works) ++lost_;
    sensor = {false, why};
}

/// Not what has just begun, only what is in trouble.
bool GrabberIntake::noneWorks() const {
    return std::all_of(sensors_.begin(), sensors_.end(),
                       [](const auto& sensor) { return !sensor.second.trouble.empty(); });
}

/// A loss that a driver told is not told a second time.
void GrabberIntake::noticeSilence() {
    if (assembled_ == 0 || silent_ || Steady::now() - lastTurn_ < stallsAfter_) return;
    silent_ = true;
    if (troubles().empty()) ++lost_;
}

std::optional<ArrivedTurn> GrabberIntake::next(const std::stop_token& stop) {
    constexpr auto look = std::chrono::milliseconds(50);  // for what is silent
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, stop, look, [this] { return !turns_.empty(); })) {
        if (stop.stop_requested()) return std::nullopt;
        noticeSilence();
    }
    ArrivedTurn turn = std::move(turns_.front());
    turns_.pop_front();
    return turn;
}

std::string GrabberIntake::troubles() const {
    std::string text;
    for (const auto& [section, sensor] : sensors_) {
        if (sensor.trouble.empty()) continue;
        text += fmt::format("{}[{}] {}", text.empty() ? "" : "; ", section, sensor.trouble);
    }
    return text;
}

SourceHealth GrabberIntake::health() const {
    const std::lock_guard lock(mutex_);
    SourceHealth health;
    health.received = assembled_;
    health.connectionsLost = lost_;
    health.message = troubles();
    if (noneWorks() || silent_) {
        health.state = SourceState::Stalled;
        if (health.message.empty()) health.message = "no scans come";
    } else if (assembled_ > 0) {
        health.state = SourceState::Running;
    }
    if (dropped_ > 0) {
        health.message += fmt::format("{}{} turns that nobody took in time",
                                      health.message.empty() ? "" : "; ", dropped_);
    }
    return health;
}

}  // namespace offmap::live
