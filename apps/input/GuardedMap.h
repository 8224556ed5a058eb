// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapFile.h>

#include <filesystem>

namespace offmap::app {

/// maps::readMap() in a child of this program, which survives what damaged files do to the
/// libraries that read them.
/// \throw std::runtime_error like readMap(), and if the child died; Interrupted
maps::MapOfFile readMapGuarded(const std::filesystem::path& file, const maps::MapOptions& options);

}  // namespace offmap::app
