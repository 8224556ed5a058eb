// SPDX-License-Identifier: BSD-3-Clause
#include "Places.h"

#include <gtest/gtest.h>

#include <cstdlib>

#ifndef OFFMAP_BINARY
#define OFFMAP_BINARY ""
#endif

namespace offmap::test {

std::filesystem::path sourceFolder() { return OFFMAP_SOURCE_DIR; }
std::filesystem::path offmapBinary() { return OFFMAP_BINARY; }

}  // namespace offmap::test

int main(int argc, char** argv) {
    // Property tests draw the same cases in every run, unless RC_PARAMS says otherwise.
    setenv("RC_PARAMS", "seed=2006", 0);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}

#if defined(__SANITIZE_ADDRESS__)
/// Asked by LeakSanitizer. fontconfig, which cairo finds its letters with, keeps what it has read
/// until the program ends; MRPT's driver of a Velodyne leaves a filter of libpcap behind.
extern "C" const char* __lsan_default_suppressions();
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): the sanitizer's own
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libpcap\n";
}
#endif
