// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/LogFiles.h"
#include "../support/RunProgram.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

namespace offmap::test {

/// MRPT's own tool finds as many objects in an output as there are in the input.
inline void expectRawlogEditReads(const std::filesystem::path& output,
                                  const std::filesystem::path& input) {
    const RunResult run = runProgram({"/usr/bin/rawlog-edit", "--info", "-i", output});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    std::smatch count;
    ASSERT_TRUE(
        std::regex_search(run.out, count, std::regex("Overall number of objects *: *([0-9]+)")));
    EXPECT_EQ(std::stoul(count[1]), entriesOf(input).size());
}

}  // namespace offmap::test
