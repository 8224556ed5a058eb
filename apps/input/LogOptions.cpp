// SPDX-License-Identifier: BSD-3-Clause
#include "LogOptions.h"

#include "SensorPoses.h"
#include "UsageError.h"

#include <offmap/rawlog/ConfigFile.h>

namespace offmap::app {

void LogOptions::addTo(CLI::App& command) {
    config.addTo(command);
    poses.addTo(command);
    command
        .add_option("--sensor-pose", sensorPoses,
                    "Where a sensor is mounted, instead of where the log says; may be repeated")
        ->type_name("LABEL=X,Y,Z,YAW_DEG,PITCH_DEG,ROLL_DEG")
        ->allow_extra_args(false);
}

rawlog::Config LogOptions::readConfig(const std::vector<std::string>& settings) const {
    rawlog::Config out;
    try {
        config.applyTo(out);
        for (const std::string& setting : settings) rawlog::applySetting(out, setting);
        poses.setSigmas(out);
        out.mountings = parseSensorPoses(sensorPoses);
        out.validate();
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
    poses.request();  // what is wrong with it is told now, not after a log has been read
    return out;
}

}  // namespace offmap::app
