// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BytesFromChild.h"

#include <offmap/maps/MapFile.h>

#include <span>

namespace offmap::app {

/// A map as one process of this program hands it to another: a line of JSON, then walls and layers
/// as they stand in memory.
Bytes packed(const maps::MapOfFile& map);
maps::MapOfFile unpacked(std::span<const uint8_t> bytes);

}  // namespace offmap::app
