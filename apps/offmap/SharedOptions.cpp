// SPDX-License-Identifier: BSD-3-Clause
#include "SharedOptions.h"

#include "SensorPoses.h"
#include "UsageError.h"

#include <offmap/rawlog/ConfigFile.h>

namespace offmap::app {

void SharedOptions::addTo(CLI::App& command) {
    command
        .add_option("--map", map, "The map: wall lines, an occupancy grid, a drawing or a picture")
        ->required()
        ->type_name("FILE");
    mapFile.addTo(command);
    command
        .add_option("--method", method,
                    "Matching method: aligned, probabilistic or paper (matching.method)")
        ->type_name("METHOD");
    config.addTo(command);
    poses.addTo(command);
    command
        .add_option("--sensor-pose", sensorPoses,
                    "Where a sensor is mounted, instead of where the log says; may be repeated")
        ->type_name("LABEL=X,Y,Z,YAW_DEG,PITCH_DEG,ROLL_DEG")
        ->allow_extra_args(false);
}

rawlog::Config SharedOptions::readConfig() const {
    rawlog::Config out;
    try {
        config.applyTo(out);
        if (!method.empty()) rawlog::applySetting(out, "matching.method=" + method);
        poses.setSigmas(out);
        out.mountings = parseSensorPoses(sensorPoses);
        out.validate();
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
    poses.request();  // what is wrong with it is told now, not after a log has been read
    return out;
}

LoadedMap SharedOptions::readMap(const rawlog::Config& configuration) const {
    return loadMap(map, mapFile.request(configuration));
}

rawlog::ChosenPoses choosePoses(const SharedOptions& options, const rawlog::Config& config,
                                const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                                bool mayBeMissing) {
    try {
        return rawlog::choosePoses(options.poses.request(), config, survey, log, mayBeMissing);
    } catch (const rawlog::PoseRequestError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace offmap::app
