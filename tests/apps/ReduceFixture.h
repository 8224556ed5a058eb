// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/LogFiles.h"
#include "../support/RunProgram.h"
#include "../support/SharedData.h"
#include "../support/TemporaryFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace offmap::test {

inline RunResult runOffmap(std::vector<std::string> arguments, const RunOptions& options = {}) {
    arguments.insert(arguments.begin(), OFFMAP_BINARY);
    return runProgram(std::move(arguments), options);
}

/// A folder that holds a map, and the log that a test puts there.
class ReduceFixture : public testing::Test {
 protected:
    using Path = std::filesystem::path;
    using Arguments = std::vector<std::string>;

    ReduceFixture() { writeFile(map_, officeMap()); }

    Arguments reduceArguments(const Arguments& more = {}) const {
        Arguments all{"reduce", in_, "--map", map_, "-o", out_};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    RunResult reduce(const Arguments& more = {}, const RunOptions& options = {}) const {
        return runOffmap(reduceArguments(more), options);
    }

    RunResult reduceLog(const Path& log, const Arguments& more = {}) {
        in_ = log;
        return reduce(more);
    }

    /// The content of every file in the folder, hidden ones too.
    std::map<std::string, std::string> content() const {
        std::map<std::string, std::string> files;
        for (const auto& file : std::filesystem::recursive_directory_iterator(folder_.path())) {
            if (file.is_regular_file()) files[file.path().string()] = readFile(file.path());
        }
        return files;
    }

    /// A cloud of the office between two poses: the smallest log that can be reduced.
    static Observations smallLog() {
        SimulatedRobot robot;
        Observations log{robot.localisation()};
        robot.wait(0.1);
        log.push_back(robot.cloud());
        robot.wait(0.1);
        log.push_back(robot.localisation());
        return log;
    }

    /// The run must fail with this code, say so in one short message, and change no file.
    template <class Matcher>
    void expectRefusal(const Arguments& arguments, int exitCode, const Matcher& message,
                       const RunOptions& options = {}) const {
        const auto before = content();
        const RunResult run = runOffmap(arguments, options);
        EXPECT_EQ(run.exitCode, exitCode) << testing::PrintToString(run);
        EXPECT_THAT(run.err, testing::AllOf(testing::StartsWith("offmap: "), message));
        EXPECT_LT(run.err.size(), 1000U) << "no message that a person would read";
        EXPECT_THAT(run.out, testing::Not(testing::HasSubstr("wrote")));
        EXPECT_EQ(content() == before, true) << "files changed, appeared or are gone";
    }

    TemporaryFolder folder_;
    Path in_ = folder_ / "in.rawlog";
    Path map_ = folder_ / "office.lines";
    Path out_ = folder_ / "out.rawlog";
};

}  // namespace offmap::test
