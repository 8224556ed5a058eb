// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <optional>
#include <string>
#include <string_view>

namespace offmap::rawlog {

/// Key of a parameter of a single sensor: "sensors.LABEL.NAME". The label may hold dots.
struct SensorKey {
    std::string label;
    std::string name;  ///< as of "sensor.NAME"
};

/// None if the key is not one of a single sensor.
/// \throw std::invalid_argument if it does not name the sensor
std::optional<SensorKey> sensorKey(std::string_view key);

/// \throw std::invalid_argument for an unknown name or a value that is not allowed. The
/// configuration is then unchanged.
void setForSensor(Config& config, const SensorKey& key, std::string_view text);

}  // namespace offmap::rawlog
