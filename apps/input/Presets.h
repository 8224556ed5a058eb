// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace offmap::app {

/// The file that --config means: itself, or, if it is a mere name and no such file is here, the
/// preset of that name. Presets stand in share/offmap/config of an installation, and in config of
/// the source tree that a program was built in.
/// \throw UsageError naming the presets there are, if there is none of that name
std::filesystem::path configFile(const std::filesystem::path& given);

}  // namespace offmap::app
