// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/RawlogReplay.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/TurnSearch.h>

#include <cmath>
#include <utility>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

RawlogReplay::RawlogReplay(std::filesystem::path log, const rawlog::LogSurvey& survey,
                           const rawlog::Config& config, double speed, AtEnd atEnd)
    : log_(std::move(log)), survey_(survey), config_(config), atEnd_(atEnd), clock_(speed) {
    open();
}

void RawlogReplay::open() {
    reader_ = std::make_unique<rawlog::RawlogReader>(log_);
    assembler_ = std::make_unique<rawlog::TurnAssembler>(config_, log_);
    rawlog::expectSweepsOf(survey_, *assembler_);
    ready_.clear();
    nextNumber_ = entries_ = 0;
    ended_ = false;
}

/// Reads on until a turn is complete. False at the end of what can be read.
bool RawlogReplay::readTurns() {
    while (ready_.empty() && !ended_) {
        const auto take = [&](std::vector<rawlog::PlacedTurn> turns) {
            for (rawlog::PlacedTurn& turn : turns) ready_.push_back(std::move(turn));
        };
        const auto entry =
            entries_ < survey_.entries ? reader_->next() : std::optional<rawlog::RawlogEntry>();
        if (!entry) {
            ended_ = true;
            take(assembler_->finish());
            break;
        }
        ++entries_;
        rawlog::forEachObservation(
            entry->object, [&](const mrpt::obs::CObservation::Ptr& obs, size_t) {
                if (survey_.reducible(*obs, config_.sensorOf(obs->sensorLabel)))
                    take(assembler_->add(obs, entry->place.index));
            });
    }
    return !ready_.empty();
}

void RawlogReplay::obeyJump(const std::stop_token& stop) {
    std::optional<uint64_t> jump;
    {
        const std::lock_guard lock(mutex_);
        jump = std::exchange(jump_, std::nullopt);
        if (!jump) return;
        clock_.restart();
    }
    if (*jump < nextNumber_) open();
    while (nextNumber_ < *jump && !stop.stop_requested() && !jumpWaits() && readTurns()) {
        ready_.pop_front();
        ++nextNumber_;
    }
}

bool RawlogReplay::jumpWaits() const {
    const std::lock_guard lock(mutex_);
    return jump_.has_value();
}

/// False if it was stopped, or something else is wanted first.
bool RawlogReplay::waitUntilDue(const rawlog::Turn& turn, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const auto wanted = [&] { return jump_.has_value(); };
    while (!stop.stop_requested() && !wanted()) {
        if (steps_ > 0) {
            --steps_;
            return true;
        }
        const auto now = Steady::now();
        const auto due = clock_.due(turn.front()->timestamp, now);
        if (due && *due <= now) return true;
        const double speed = clock_.speed();
        const auto other = [&] {
            return wanted() || steps_ > 0 || clock_.paused() == due.has_value() ||
                   clock_.speed() != speed;
        };
        if (due) {
            changed_.wait_until(lock, stop, *due, other);
        } else {
            changed_.wait(lock, stop, other);
        }
    }
    return false;
}

/// At the end of the log. False if nothing more comes.
bool RawlogReplay::waitForJump(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    health_.state = SourceState::Ended;
    if (atEnd_ == AtEnd::Stop) return jump_.has_value();
    return changed_.wait(lock, stop, [&] { return jump_.has_value(); });
}

std::optional<ArrivedTurn> RawlogReplay::next(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        try {
            obeyJump(stop);
            if (jumpWaits()) continue;
            if (!readTurns()) {
                if (waitForJump(stop)) continue;
                return std::nullopt;
            }
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            health_.state = SourceState::Failed;
            health_.message = error.what();
            return std::nullopt;
        }
        if (!waitUntilDue(ready_.front().turn, stop)) continue;
        ArrivedTurn turn{std::move(ready_.front().turn), nextNumber_++, Steady::now()};
        ready_.pop_front();
        const std::lock_guard lock(mutex_);
        health_.state = SourceState::Running;
        ++health_.received;
        return turn;
    }
    return std::nullopt;
}

SourceHealth RawlogReplay::health() const {
    const std::lock_guard lock(mutex_);
    return health_;
}

bool RawlogReplay::waits() const {
    const std::lock_guard lock(mutex_);
    return std::isinf(clock_.speed()) || clock_.paused();
}

void RawlogReplay::setSpeed(double speed) {
    {
        const std::lock_guard lock(mutex_);
        clock_.setSpeed(speed, Steady::now());
    }
    changed_.notify_all();
}

void RawlogReplay::pause() {
    {
        const std::lock_guard lock(mutex_);
        clock_.pause(Steady::now());
    }
    changed_.notify_all();
}

void RawlogReplay::resume() {
    {
        const std::lock_guard lock(mutex_);
        clock_.resume(Steady::now());
    }
    changed_.notify_all();
}

void RawlogReplay::step() {
    {
        const std::lock_guard lock(mutex_);
        ++steps_;
    }
    changed_.notify_all();
}

void RawlogReplay::jumpTo(uint64_t number) {
    {
        const std::lock_guard lock(mutex_);
        jump_ = number;
        steps_ = clock_.paused() ? 1 : 0;
    }
    changed_.notify_all();
}

}  // namespace offmap::live
