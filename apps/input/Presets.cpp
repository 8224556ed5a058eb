// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "UsageError.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

namespace offmap::app {

namespace fs = std::filesystem;

namespace {

/// Empty if the program stands alone. It is known by its default.yaml: a folder config of something
/// else may lie in either place.
fs::path presetFolder() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    for (const char* place : {"../share/offmap/config", "../../../config"}) {
        fs::path folder = (program.parent_path() / place).lexically_normal();
        if (fs::is_regular_file(folder / "default.yaml", ignored)) return folder;
    }
    return {};
}

/// "default, indoor, outdoor"
std::string namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& file : fs::directory_iterator(folder, ignored)) {
        if (file.path().extension() == ".yaml") names.push_back(file.path().stem().string());
    }
    std::ranges::sort(names);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

fs::path configFile(const fs::path& given) {
    std::error_code ignored;
    if (given.has_parent_path() || given.has_extension()) return given;
    if (fs::exists(given, ignored) && !fs::is_directory(given, ignored)) return given;
    const fs::path folder = presetFolder();
    if (folder.empty()) {
        throw UsageError(
            fmt::format("--config is '{}': there is no such file here, and no preset beside this "
                        "program; name a file",
                        given.string()));
    }
    fs::path preset = folder / (given.string() + ".yaml");
    if (fs::is_regular_file(preset, ignored)) return preset;
    throw UsageError(fmt::format(
        "--config is '{}': there is no such file here, and no such preset; there are: {}",
        given.string(), namesIn(folder)));
}

}  // namespace offmap::app
