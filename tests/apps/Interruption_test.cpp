// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/Scans.h"
#include "ReduceFixture.h"

#include <csignal>
#include <thread>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// A log that takes several seconds, quickly made: one gzip member over and over again.
class Interruption : public ReduceFixture {
 protected:
    Interruption() {
        SimulatedRobot robot;
        const std::string scan = gzipped(bytesOf(*robot.vlp16()));
        std::string log;
        for (int i = 0; i < 1500; ++i) log += scan;
        writeFile(in_, log);
    }

    /// Until something of the output stands on the disk.
    void waitUntilItWrites(const RunningProgram& program) const {
        while (program.runs()) {
            std::error_code gone;
            for (const auto& file : std::filesystem::directory_iterator(folder_.path())) {
                if (file.path().extension() == ".part" && file.file_size(gone) > 0) return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        FAIL() << "it ended before it could be interrupted";
    }

    void expectQuietEnd(bool toTheGroup, int signal, int exitCode) const {
        RunOptions options;
        options.ownGroup = true;
        std::vector<std::string> command =
            reduceArguments({"--pose", "2,2.5,17.2", "--removed", folder_ / "removed.rawlog",
                             "--report", folder_ / "report.json"});
        command.insert(command.begin(), offmapBinary());
        RunningProgram program(command, options);
        waitUntilItWrites(program);
        kill(toTheGroup ? -program.id() : program.id(), signal);
        const RunResult run = program.wait();
        EXPECT_EQ(run.exitCode, exitCode) << testing::PrintToString(run);
        EXPECT_THAT(run.err, HasSubstr("interrupted; nothing was written"));
        EXPECT_THAT(folder_.names(), UnorderedElementsAre("in.rawlog", "office.lines"));
    }
};

TEST_F(Interruption, ofTheProgramLeavesNoFile) { expectQuietEnd(false, SIGINT, 130); }

TEST_F(Interruption, ofItsGroupLeavesNoFile) { expectQuietEnd(true, SIGINT, 130); }

TEST_F(Interruption, byTerminationLeavesNoFile) { expectQuietEnd(false, SIGTERM, 143); }

TEST_F(Interruption, byTheEndOfTheTerminalLeavesNoFile) { expectQuietEnd(true, SIGHUP, 129); }

}  // namespace
