// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/bits_math.h>

#include <stdexcept>

namespace offmap::rawlog {

void SensorConfig::validate() const {
    if (!(maxColumnPause > 0)) {
        throw std::invalid_argument("sensor.max_column_pause_s must be greater than 0");
    }
    if (!(columnWidth >= 0 && columnWidth <= mrpt::DEG2RAD(30.0))) {
        throw std::invalid_argument("sensor.column_width_deg must lie in 0 ... 30");
    }
}

mrpt::poses::CPose3D sensorInVehicle(const mrpt::obs::CObservation& obs,
                                     const SensorConfig& config) {
    if (config.mounting) return *config.mounting;
    mrpt::poses::CPose3D pose;
    obs.getSensorPose(pose);
    return pose;
}

}  // namespace offmap::rawlog
