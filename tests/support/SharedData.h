// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Places.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace offmap::test {

/// Real office scans are not part of the source tree: they stand in the folder that the environment
/// variable OFFMAP_SHARED_DATA names, else in shared/data beside the source folder.
inline std::filesystem::path sharedData(std::string_view name) {
    const char* folder = std::getenv("OFFMAP_SHARED_DATA");
    return (folder != nullptr ? std::filesystem::path(folder) : sourceFolder() / "../shared/data") /
           name;
}

/// Whether a test may do without them: a machine that was not given them, but not the one that
/// judges changes, which has to notice if they are gone.
inline bool mayLackSharedData() {
    return !std::filesystem::exists(sharedData("room")) && !std::getenv("OFFMAP_SHARED_DATA") &&
           !std::getenv("CI");
}

/// A file of the source tree.
inline std::filesystem::path sourceFile(std::string_view name) { return sourceFolder() / name; }

}  // namespace offmap::test

/// First statement of a test or a SetUp() that reads sharedData().
#define OFFMAP_NEEDS_SHARED_DATA()                                                          \
    if (offmap::test::mayLackSharedData()) {                                                \
        GTEST_SKIP() << "needs the real office scans; OFFMAP_SHARED_DATA tells the folder"; \
    }
