// SPDX-License-Identifier: BSD-3-Clause
#include "NamedFiles.h"

#include "UsageError.h"

#include <fmt/format.h>

#include <system_error>

namespace offmap::app {

namespace {

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code ignored;
    if (std::filesystem::equivalent(a, b, ignored)) return true;
    return std::filesystem::weakly_canonical(a, ignored) ==
           std::filesystem::weakly_canonical(b, ignored);
}

}  // namespace

void requireDistinct(const std::vector<NamedFile>& files) {
    for (size_t a = 0; a < files.size(); ++a) {
        for (size_t b = a + 1; b < files.size(); ++b) {
            const auto& [nameA, fileA] = files[a];
            const auto& [nameB, fileB] = files[b];
            if (fileA.empty() || fileB.empty() || !sameFile(fileA, fileB)) continue;
            throw UsageError(fmt::format("{} and {} are the same file, {}; give each its own",
                                         nameA, nameB, fileB.string()));
        }
    }
}

}  // namespace offmap::app
