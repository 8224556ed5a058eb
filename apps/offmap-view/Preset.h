// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <filesystem>
#include <string>

namespace offmap::window {

/// What differs from the default as YAML, section by section, as --config takes it. Mountings are
/// not part of such a file.
std::string presetOf(const rawlog::Config& config);

/// Writes presetOf() over whatever stood there, at once as a whole.
/// \throw std::runtime_error naming the file, the cause and the fix
void savePreset(const std::filesystem::path& file, const rawlog::Config& config);

/// The default with what the file says, as --config has it, and with the mountings of `config`.
/// \throw std::runtime_error naming file, line, key and what is allowed
rawlog::Config loadPreset(const std::filesystem::path& file, const rawlog::Config& config);

}  // namespace offmap::window
