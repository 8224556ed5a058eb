// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ParameterTable.h>
#include <offmap/rawlog/SensorSettings.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::rawlog {

std::optional<SensorKey> sensorKey(std::string_view key) {
    constexpr std::string_view section = "sensors.";
    if (!key.starts_with(section)) return std::nullopt;
    const std::string_view own = key.substr(section.size());
    const size_t dot = own.rfind('.');
    if (dot == std::string_view::npos) {
        throw std::invalid_argument(fmt::format(
            "\"{}\" names no sensor; write sensors.LABEL.{}, or sensor.{} for all", key, own, own));
    }
    return SensorKey{std::string(own.substr(0, dot)), std::string(own.substr(dot + 1))};
}

void setForSensor(Config& config, const SensorKey& key, std::string_view text) {
    Config tried;
    findSensorParameter(key.name).setText(tried, text);
    config.sensors[key.label][key.name] = text;
}

}  // namespace offmap::rawlog
