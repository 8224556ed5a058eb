// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <chrono>
#include <optional>

namespace offmap::live {

/// When what a log holds is due, if it is replayed so many times as fast as it was recorded. Pure:
/// it is told what time it is. Not to be used by two threads at once.
class ReplayClock {
 public:
    using LogTime = mrpt::Clock::time_point;
    using SteadyTime = std::chrono::steady_clock::time_point;

    /// \param speed > 0; infinite: everything is due at once
    /// \throw std::invalid_argument for another one
    explicit ReplayClock(double speed);

    double speed() const { return speed_; }
    bool paused() const { return paused_; }

    /// From now on. \throw std::invalid_argument as above
    void setSpeed(double speed, SteadyTime now);
    void pause(SteadyTime now);
    void resume(SteadyTime now);
    /// The next time that is asked for is due at once: after a jump in the log.
    void restart() { anchorLog_.reset(); }

    /// When a time of the log is due; none while it is paused. The first one is due at once, and
    /// one from before the last one as well, which a log that jumps back gives.
    std::optional<SteadyTime> due(LogTime time, SteadyTime now);

 private:
    /// Log time now.
    LogTime at(SteadyTime now) const;
    void anchorAt(SteadyTime now);

    double speed_;
    bool paused_ = false;
    std::optional<LogTime> anchorLog_;
    SteadyTime anchor_{};
};

}  // namespace offmap::live
