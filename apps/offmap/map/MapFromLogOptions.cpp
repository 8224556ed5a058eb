// SPDX-License-Identifier: BSD-3-Clause
#include "MapFromLogOptions.h"

#include "input/NumberList.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <cmath>

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
    LogOptions::addTo(command);
    command.add_flag("--force", force, "Replace an existing MAP");
}

rawlog::Config MapFromLogOptions::readConfig() const {
    if (!(minLength >= 0) || !std::isfinite(minLength)) {
        throw UsageError(fmt::format("--min-length is {}, but no length is", minLength));
    }
    return LogOptions::readConfig();
}

}  // namespace offmap::app
