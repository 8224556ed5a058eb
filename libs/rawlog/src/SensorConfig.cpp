// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/bits_math.h>

#include <cmath>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

void requirePairs(const std::vector<double>& sigmaByIntensity) {
    bool usable = sigmaByIntensity.size() % 2 == 0;
    for (size_t i = 0; usable && i < sigmaByIntensity.size(); i += 2) {
        usable = sigmaByIntensity[i + 1] > 0 &&
                 (i == 0 || sigmaByIntensity[i] >= sigmaByIntensity[i - 2]);
    }
    if (usable) return;
    throw std::invalid_argument(
        "sensor.range_sigma_by_intensity_m must be pairs of an intensity and a sigma above 0, the "
        "intensities ascending");
}

}  // namespace

void SensorConfig::validate() const {
    if (!(maxColumnPause > 0)) {
        throw std::invalid_argument("sensor.max_column_pause_s must be greater than 0");
    }
    if (!(columnWidth >= 0 && columnWidth <= mrpt::DEG2RAD(30.0))) {
        throw std::invalid_argument("sensor.column_width_deg must lie in 0 ... 30");
    }
    requirePairs(rangeSigmaByIntensity);
    if (!(minRange >= 0 && std::isfinite(minRange))) {
        throw std::invalid_argument("sensor.min_range_m must be finite and not negative");
    }
    if (robotBox && !(robotBox->min.x < robotBox->max.x && robotBox->min.y < robotBox->max.y &&
                      robotBox->min.z < robotBox->max.z)) {
        throw std::invalid_argument(
            "sensor.robot_box_m must be x_min, x_max, y_min, y_max, z_min, z_max, each min less "
            "than its max");
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
