// SPDX-License-Identifier: BSD-3-Clause
#include "MapSource.h"

#include "../Console.h"
#include "../Guarded.h"
#include "../UsageError.h"

namespace offmap::app {

void MapSource::addTo(CLI::App& command) {
    command
        .add_option("MAP", file,
                    "The map: wall lines, an occupancy grid, a drawing or a picture; it is only "
                    "read")
        ->required()
        ->type_name("FILE");
    reading.addTo(command);
    config.addTo(command);
}

maps::MapOptions MapSource::request() const {
    rawlog::Config parameters;
    config.applyTo(parameters);
    try {
        parameters.validate();
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
    return reading.request(parameters);
}

int workOnMap(const MapSource& source,
              const std::function<int(const maps::MapOfFile&, rawlog::GuardedStatus&)>& work) {
    using Kind = rawlog::GuardedOutcome::Kind;
    const maps::MapOptions request = source.request();
    const auto outcome = reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
        return work(maps::readMap(source.file, request), status);
    });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    say(stderr, "offmap: {}: its reader failed: {}; the file is damaged or far too large\n",
        source.file.string(), outcome.cause);
    return exitFailed;
}

}  // namespace offmap::app
