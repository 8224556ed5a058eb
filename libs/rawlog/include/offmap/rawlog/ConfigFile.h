// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::rawlog {

/// Sets what a YAML file says; what it does not mention stays. The file holds one map of sections,
/// each a map of keys: `vertical: {max_tilt_deg: 5}`. The keys are those of ParameterTable.h.
/// \return the keys that it set, in its order
/// \throw std::runtime_error naming file, line, key and what is allowed, for a file that cannot be
/// read, a syntax error, an unknown or repeated key, a value of the wrong type or out of its
/// limits. The configuration is then unchanged.
std::vector<std::string> applyYaml(Config& config, const std::filesystem::path& file);

/// Sets one parameter: "vertical.max_tilt_deg=4".
/// \throw std::runtime_error like applyYaml(). The configuration is then unchanged.
void applySetting(Config& config, std::string_view setting);

}  // namespace offmap::rawlog
