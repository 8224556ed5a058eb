// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/ParameterTable.h>

namespace offmap::rawlog {

void Config::validate() const {
    for (const Parameter& p : parameters()) p.check(*this);
    reduction.validate();
    sensor.validate();
    for (const auto& [label, settings] : sensors) sensorOf(label).validate();
}

SensorConfig Config::sensorOf(const std::string& label) const {
    Config own;
    own.sensor = sensor;
    if (const auto set = sensors.find(label); set != sensors.end()) {
        for (const auto& [name, text] : set->second) {
            findParameter("sensor." + name).setText(own, text);
        }
    }
    if (const auto mounting = mountings.find(label); mounting != mountings.end()) {
        own.sensor.mounting = mrpt::poses::CPose3D(mounting->second);
    }
    return own.sensor;
}

}  // namespace offmap::rawlog
