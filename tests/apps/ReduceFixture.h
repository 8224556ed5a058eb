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
#include <random>
#include <string>
#include <vector>

namespace offmap::test {

inline RunResult runOffmap(std::vector<std::string> arguments, const RunOptions& options = {}) {
    arguments.insert(arguments.begin(), offmapBinary());
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

    /// A byte changed somewhere in the first `range` ones.
    static std::string withByteFlipped(std::string bytes, size_t range, std::mt19937& random) {
        const size_t place = std::uniform_int_distribution<size_t>(0, range - 1)(random);
        bytes[place] = static_cast<char>(std::uniform_int_distribution<int>(0, 255)(random));
        return bytes;
    }

    /// Not every flipped byte can be noticed: a range is a range. But the program either writes a
    /// whole log (true), or says where its input is damaged and writes none (false).
    bool reducesOrRefuses(const std::string& log, Arguments more = {}) const {
        writeFile(in_, log);
        more.push_back("--force");
        const RunResult run = reduce(more);
        EXPECT_THAT(run.exitCode, testing::AnyOf(0, 2)) << testing::PrintToString(run);
        if (run.exitCode == 0) {
            EXPECT_EQ(entriesOf(out_).size(), entriesOf(in_).size());
            std::filesystem::remove(out_);
        } else {
            EXPECT_THAT(run.err, testing::HasSubstr(in_.string()));
        }
        EXPECT_THAT(folder_.names(), testing::UnorderedElementsAre("in.rawlog", "office.lines"));
        return run.exitCode == 0;
    }

    TemporaryFolder folder_;
    Path in_ = folder_ / "in.rawlog";
    Path map_ = folder_ / "office.lines";
    Path out_ = folder_ / "out.rawlog";
};

}  // namespace offmap::test
