// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace offmap::test {

/// A recorded scan. They are too large for the source tree: they stand in the folder that the
/// environment variable OFFMAP_SHARED_DATA names, else in shared/data beside the source folder.
inline std::filesystem::path sharedData(std::string_view name) {
    const char* folder = std::getenv("OFFMAP_SHARED_DATA");
    return (folder != nullptr ? std::filesystem::path(folder)
                              : std::filesystem::path(OFFMAP_SOURCE_DIR) / "../shared/data") /
           name;
}

/// A file of the source tree.
inline std::filesystem::path sourceFile(std::string_view name) {
    return std::filesystem::path(OFFMAP_SOURCE_DIR) / name;
}

}  // namespace offmap::test
