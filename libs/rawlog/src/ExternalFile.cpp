// SPDX-License-Identifier: BSD-3-Clause
#include "ExternalFile.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace offmap::rawlog {

namespace fs = std::filesystem;

fs::path findExternalFile(const std::string& what, const std::string& label, const fs::path& name,
                          const fs::path& rawlogFile) {
    const fs::path folder = rawlogFile.parent_path();
    const std::array<fs::path, 3> candidates = {
        folder / (rawlogFile.stem().string() + "_Images") / name, folder / "Images" / name,
        folder / name};
    for (const fs::path& file : candidates) {
        if (fs::is_regular_file(file)) return fs::absolute(file);
    }
    throw std::runtime_error(fmt::format(
        "the {} of '{}' is stored in '{}', which is neither in '{}' nor in '{}'; put it there or "
        "use a log made by rawlog-edit --de-externalize",
        what, label, name.string(), candidates[0].parent_path().string(),
        candidates[2].parent_path().string()));
}

}  // namespace offmap::rawlog
