// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/SimulatedRobot.h"

#include <mrpt/hwdrivers/CGenericSensor.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace offmap::test {

/// A driver for rawlog-grabber's files that delivers a cloud of the office and a robot pose each
/// time, and fails as it is told to.
class FakeLidar : public mrpt::hwdrivers::CGenericSensor {
    DEFINE_GENERIC_SENSOR(FakeLidar)

 public:
    enum class Does { Work, ThrowAtInitialize, ThrowAtProcess, TellOfError, Nothing, Block };

    /// Of all.
    static inline std::atomic<Does> does{Does::Work};
    static inline std::atomic<int> initialised{0}, blocked{0};

    void initialize() override {
        ++initialised;
        if (does == Does::ThrowAtInitialize) throw std::runtime_error("no cable");
    }
    void doProcess() override {
        while (does == Does::Block) {
            blocked = 1;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (does == Does::ThrowAtProcess) throw std::runtime_error("unplugged");
        m_state = does == Does::TellOfError ? ssError : ssWorking;
        if (does != Does::Work) return;
        appendObservations({robot_.localisation(), robot_.cloud(m_sensorLabel, 12)});
        robot_.wait(0.1);
    }

 protected:
    void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& settings,
                                   const std::string& section) override {
        m_sensorLabel = settings.read_string(section, "sensorLabel", "FAKE");
        if (settings.read_bool(section, "impossible", false))
            throw std::invalid_argument("impossible is not possible");
    }

 private:
    SimulatedRobot robot_;
};

}  // namespace offmap::test
