// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/ReplayClock.h>

#include <cmath>
#include <stdexcept>

namespace offmap::live {

namespace {

double checked(double speed) {
    if (!(speed > 0)) throw std::invalid_argument("a replay's speed has to be above 0");
    return speed;
}

template <class Duration>
Duration times(Duration duration, double factor) {
    const std::chrono::duration<double> seconds(duration);
    return std::chrono::duration_cast<Duration>(seconds * factor);
}

}  // namespace

ReplayClock::ReplayClock(double speed) : speed_(checked(speed)) {}

ReplayClock::LogTime ReplayClock::at(SteadyTime now) const {
    if (paused_ || std::isinf(speed_)) return *anchorLog_;
    const auto passed = std::chrono::duration_cast<LogTime::duration>(now - anchor_);
    return *anchorLog_ + times(passed, speed_);
}

void ReplayClock::anchorAt(SteadyTime now) {
    if (anchorLog_) anchorLog_ = at(now);
    anchor_ = now;
}

void ReplayClock::setSpeed(double speed, SteadyTime now) {
    checked(speed);
    anchorAt(now);
    speed_ = speed;
}

void ReplayClock::pause(SteadyTime now) {
    anchorAt(now);
    paused_ = true;
}

void ReplayClock::resume(SteadyTime now) {
    paused_ = false;
    anchor_ = now;
}

std::optional<ReplayClock::SteadyTime> ReplayClock::due(LogTime time, SteadyTime now) {
    if (paused_) return std::nullopt;
    if (std::isinf(speed_) || !anchorLog_ || time < *anchorLog_) {
        anchorLog_ = time;
        anchor_ = now;
        return now;
    }
    const auto wait =
        std::chrono::duration_cast<SteadyTime::duration>(times(time - *anchorLog_, 1 / speed_));
    return anchor_ + wait;
}

}  // namespace offmap::live
