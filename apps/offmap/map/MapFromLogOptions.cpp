// SPDX-License-Identifier: BSD-3-Clause
#include "MapFromLogOptions.h"

#include "../NumberList.h"
#include "../SensorPoses.h"
#include "../UsageError.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace offmap::app {

void MapFromLogOptions::addTo(CLI::App& command) {
    command.add_option("LOG", logs, "Rawlogs whose poses are in one frame; they are only read")
        ->required()
        ->type_name("FILE");
    command
        .add_option("-o,--out", output,
                    "The map, in the format of its extension: .lines, .dxf, .geojson, .svg, "
                    "a grid")
        ->required()
        ->type_name("MAP")
        ->check(notEmpty);
    command.add_option("--min-length", minLength, "Shorter lines are no walls (0.5)")
        ->type_name("METRES");
    command
        .add_option("--min-scans", minScans,
                    "Scans that must show a wall (1; 3 where there are at least 10)")
        ->check(CLI::Range(1, 1'000'000).description(""))
        ->type_name("N");
    config.addTo(command);
    poses.addTo(command);
    command
        .add_option("--sensor-pose", sensorPoses,
                    "Where a sensor is mounted, instead of where the log says; may be repeated")
        ->type_name("LABEL=X,Y,Z,YAW_DEG,PITCH_DEG,ROLL_DEG")
        ->allow_extra_args(false);
    command.add_flag("--force", force, "Replace an existing MAP");
}

rawlog::Config MapFromLogOptions::readConfig() const {
    if (!(minLength >= 0) || !std::isfinite(minLength)) {
        throw UsageError(fmt::format("--min-length is {}, but no length is", minLength));
    }
    rawlog::Config out;
    try {
        config.applyTo(out);
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
