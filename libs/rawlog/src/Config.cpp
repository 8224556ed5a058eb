// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LayerSettings.h>
#include <offmap/rawlog/ParameterTable.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::rawlog {

void Config::validate() const {
    for (const Parameter& p : parameters()) p.check(*this);
    reduction.validate();
    sensor.validate();
    validateLayers(*this);
    for (const auto& [label, settings] : sensors) {
        try {
            sensorOf(label).validate();
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument(fmt::format("sensors.{}: {}", label, e.what()));
        }
    }
}

SensorConfig Config::sensorOf(const std::string& label) const {
    Config own;
    own.sensor = sensor;
    if (const auto set = sensors.find(label); set != sensors.end()) {
        for (const auto& [name, text] : set->second) {
            findSensorParameter(name).setText(own, text);
        }
    }
    if (const auto mounting = mountings.find(label); mounting != mountings.end()) {
        own.sensor.mounting = mrpt::poses::CPose3D(mounting->second);
    }
    return own.sensor;
}

}  // namespace offmap::rawlog
