// SPDX-License-Identifier: BSD-3-Clause
#include "MapSource.h"

#include "input/GuardedMap.h"
#include "input/UsageError.h"

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

maps::MapOfFile MapSource::read() const { return readMapGuarded(file, request()); }

}  // namespace offmap::app
