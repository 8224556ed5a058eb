// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/GrabberSource.h>
#include <offmap/rawlog/TurnAssembler.h>

#include <mrpt/hwdrivers/CGenericSensor.h>

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>

namespace offmap::live {

/// Where the threads of all sensors bring what they observe, and who is in trouble. Any thread may
/// use it.
class GrabberIntake {
 public:
    using Observations = mrpt::hwdrivers::CGenericSensor::TListObservations;

    GrabberIntake(rawlog::Config config, std::shared_ptr<LivePoses> poses, std::string poseLabel,
                  std::chrono::milliseconds stallsAfter, const std::vector<std::string>& sections);

    void take(const Observations& observations);
    void works(const std::string& section);
    void fails(const std::string& section, const std::string& why);

    std::optional<ArrivedTurn> next(const std::stop_token& stop);
    SourceHealth health() const;

 private:
    struct Sensor {
        bool works = false;
        std::string trouble;
    };
    void take(const mrpt::obs::CObservation::Ptr& obs);
    bool noneWorks() const;
    void noticeSilence();
    std::string troubles() const;

    const rawlog::Config config_;
    const std::shared_ptr<LivePoses> poses_;
    const std::string poseLabel_;
    const std::chrono::milliseconds stallsAfter_;

    mutable std::mutex mutex_;  // of what follows
    mutable std::condition_variable_any changed_;
    rawlog::TurnAssembler assembler_;
    std::map<std::string, Sensor> sensors_;
    std::deque<ArrivedTurn> turns_;
    uint64_t assembled_ = 0, dropped_ = 0, lost_ = 0;
    SteadyTime lastTurn_{};
    bool silent_ = false;
};

}  // namespace offmap::live
