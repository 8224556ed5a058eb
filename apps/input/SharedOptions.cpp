// SPDX-License-Identifier: BSD-3-Clause
#include "SharedOptions.h"

#include "UsageError.h"

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
    LogOptions::addTo(command);
}

rawlog::Config SharedOptions::readConfig() const {
    if (method.empty()) return LogOptions::readConfig();
    return LogOptions::readConfig({"matching.method=" + method});
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
