// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/RandomScenes.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace offmap::evaluation {

/// The scenes that there are, by the names of a command line: those of SampleWorlds.h with a sensor
/// where it sees what they hold, and those of RandomScenes.h.
std::vector<std::string_view> sceneNames();

/// \param seed of a random scene; the others are always the same
std::optional<Scene> sceneNamed(std::string_view name, uint64_t seed);

}  // namespace offmap::evaluation
