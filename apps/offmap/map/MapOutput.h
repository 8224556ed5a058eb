// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MapSource.h"

#include <offmap/rawlog/OutputFile.h>

#include <functional>
#include <string>
#include <vector>

namespace offmap::app {

/// A file that is made of a map.
struct MapOutput {
    std::filesystem::path file;
    bool force = false;
    std::vector<std::filesystem::path> companions;  ///< files that are written with it

    void addTo(CLI::App& command, const char* what, const char* typeName);

    /// ".dxf", in lower case; of "x.gridmap.gz" ".gz".
    std::string extension() const;
};

/// Reads the map, says its warnings, and lets the work write files in a child of this program, so
/// that no unfinished one stays whatever happens. \return the exit code
int writeFromMap(const MapSource& source, const MapOutput& output,
                 const std::function<void(const maps::MapOfFile&, rawlog::OutputOptions)>& work);

}  // namespace offmap::app
