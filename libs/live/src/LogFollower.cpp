// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/LogFollower.h>
#include <offmap/rawlog/Observations.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

LogFollower::LogFollower(std::filesystem::path log, const rawlog::Config& config,
                         std::shared_ptr<LivePoses> poses, Options options)
    : log_(std::move(log)),
      config_(config),
      options_(std::move(options)),
      poses_(std::move(poses)),
      assembler_(config_, log_),
      lastBytes_(Steady::now()) {}

/// Where the file ends for now. False if it was stopped, or the file became shorter.
bool LogFollower::waitForMore() {
    constexpr auto look = std::chrono::milliseconds(20);
    while (!stop_->stop_requested()) {
        std::error_code error;
        const uintmax_t size = std::filesystem::file_size(log_, error);
        const uintmax_t read = reader_ ? reader_->compressedPosition() : 0;
        if (error || size < read) {
            throw std::runtime_error(log_.string() + " is gone or became shorter");
        }
        if (size > read) {
            lastBytes_ = Steady::now();
            return true;
        }
        if (Steady::now() - lastBytes_ > options_.stallsAfter) {
            const std::lock_guard lock(mutex_);
            if (health_.state == SourceState::Running) ++health_.connectionsLost;
            health_.state = SourceState::Stalled;
            health_.message = fmt::format("{} does not grow", log_.string());
        }
        std::this_thread::sleep_for(look);
    }
    return false;
}

void LogFollower::take(const mrpt::obs::CObservation::Ptr& obs, uint64_t entry) {
    const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(obs.get());
    if (pose && poses_ && (options_.poseLabel.empty() || options_.poseLabel == obs->sensorLabel)) {
        poses_->add(rawlog::stampedPose(*pose));
    }
    for (rawlog::PlacedTurn& turn : assembler_.add(obs, entry)) ready_.push_back(std::move(turn));
}

/// Waits for an entry. False at the end, which there is only where it was stopped.
bool LogFollower::readEntry() {
    if (!reader_) {
        reader_ = std::make_unique<rawlog::RawlogReader>(log_, [this] { return waitForMore(); });
    }
    const auto entry = reader_->next();
    if (!entry) return false;
    rawlog::forEachObservation(entry->object, [&](const mrpt::obs::CObservation::Ptr& obs, size_t) {
        take(obs, entry->place.index);
    });
    return true;
}

std::optional<ArrivedTurn> LogFollower::next(const std::stop_token& stop) {
    stop_ = &stop;
    try {
        while (ready_.empty()) {
            if (stop.stop_requested() || !readEntry()) return std::nullopt;
        }
    } catch (const std::exception& error) {
        if (stop.stop_requested()) return std::nullopt;  // in the middle of an entry
        const std::lock_guard lock(mutex_);
        health_.state = SourceState::Failed;
        health_.message = error.what();
        return std::nullopt;
    }
    rawlog::PlacedTurn turn = std::move(ready_.front());
    ready_.pop_front();
    const std::lock_guard lock(mutex_);
    health_.state = SourceState::Running;
    health_.message.clear();
    return ArrivedTurn{std::move(turn.turn), health_.received++, Steady::now()};
}

SourceHealth LogFollower::health() const {
    const std::lock_guard lock(mutex_);
    return health_;
}

}  // namespace offmap::live
