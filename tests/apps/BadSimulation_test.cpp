// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateFixture.h"

#include <csignal>
#include <thread>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class BadSimulation : public SimulateFixture {
 protected:
    /// One message, the exit code, and no file.
    template <class Matcher>
    void expectRefusal(const Arguments& arguments, int exitCode, const Matcher& message) const {
        const RunResult run = runOffmap(arguments);
        EXPECT_EQ(run.exitCode, exitCode) << testing::PrintToString(run);
        EXPECT_THAT(run.err, AllOf(testing::StartsWith("offmap: "), message));
        EXPECT_LT(run.err.size(), 600U) << "no message that a person would read";
        EXPECT_THAT(folder_.names(), IsEmpty());
    }

    template <class Matcher>
    void expectUsageError(const Arguments& options, const Matcher& message) const {
        expectRefusal(simulateArguments("office_room", options), 1, message);
    }
};

TEST_F(BadSimulation, unknownWorldIsToldWithThoseThatThereAre) {
    expectRefusal(
        simulateArguments("kitchen"), 1,
        AllOf(HasSubstr("'kitchen'"), HasSubstr("office_room"), HasSubstr("random_room")));
}

TEST_F(BadSimulation, folderIsNeeded) {
    expectRefusal({"simulate", "office_room"}, 1, HasSubstr("--out is required"));
}

TEST_F(BadSimulation, numbersOutOfReachAreTold) {
    expectUsageError({"--range-noise", "-0.1"}, HasSubstr("'-0.1' is no number from 0 to 1"));
    expectUsageError({"--range-noise", "nan"}, HasSubstr("--range-noise: 'nan'"));
    expectUsageError({"--angle-noise", "1deg"}, HasSubstr("--angle-noise: '1deg'"));
    expectUsageError({"--tilt", "90"}, HasSubstr("from 0 to 15"));
    expectUsageError({"--map-error", "inf"}, HasSubstr("--map-error: 'inf'"));
    expectUsageError({"--stated-factor", "0"}, HasSubstr("--stated-factor: '0'"));
    expectUsageError({"--scans", "0"}, HasSubstr("--scans: '0'"));
    expectUsageError({"--seed", "-1"}, HasSubstr("--seed: '-1' is negative"));
    expectUsageError({"--speed", "-1"}, HasSubstr("--speed: '-1'"));
    expectUsageError({"--pose-sigma", "0.1"}, HasSubstr("--pose-sigma is '0.1', but must be"));
    expectUsageError({"--pose-sigma", "0.1,-1"}, HasSubstr("0 to 10 m, 0 to 90 degrees"));
}

TEST_F(BadSimulation, unknownClassAndScannerAreTold) {
    expectUsageError({"--class", "sonar"}, HasSubstr("--class"));
    expectUsageError({"--scanner", "hdl32"}, HasSubstr("--scanner"));
}

TEST_F(BadSimulation, scannerThatAClassCannotHoldIsRefused) {
    expectUsageError({"--class", "velodyne", "--scanner", "dense"},
                     HasSubstr("packets of a VLP-16: leave out --scanner dense"));
    expectUsageError({"--class", "rangeimage", "--scanner", "paper"},
                     HasSubstr("of a depth camera: leave out --scanner paper"));
}

TEST_F(BadSimulation, compensationNeedsMovement) {
    expectUsageError({"--no-compensation"}, HasSubstr("add --speed or --yaw-rate"));
    expectUsageError({"--no-compensation", "--speed", "1", "--class", "rangeimage"},
                     HasSubstr("an image is taken at once"));
}

TEST_F(BadSimulation, roomForTheMovementIsNeeded) {
    expectUsageError({"--speed", "20"}, AllOf(HasSubstr("48.0 m"), HasSubstr("lower --speed")));
}

TEST_F(BadSimulation, existingFilesNeedForce) {
    std::filesystem::create_directory(sim_);
    writeFile(sim_ / "map.lines", "my plan");
    const RunResult run = runOffmap(simulateArguments("office_room", {"--scans", "1"}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, AllOf(HasSubstr((sim_ / "map.lines").string()), HasSubstr("--force")));
    EXPECT_EQ(readFile(sim_ / "map.lines"), "my plan");
    EXPECT_THAT(std::distance(std::filesystem::directory_iterator(sim_), {}), 1);
}

TEST_F(BadSimulation, fileInPlaceOfTheFolderIsTold) {
    writeFile(sim_, "a file");
    const RunResult run = runOffmap(simulateArguments("office_room"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, AllOf(HasSubstr(sim_.string()), HasSubstr("a folder is needed")));
    EXPECT_EQ(readFile(sim_), "a file");
}

TEST_F(BadSimulation, interruptionLeavesNothing) {
    auto command = simulateArguments("office_room", {"--scans", "1000", "--scanner", "dense"});
    command.insert(command.begin(), offmapBinary());
    RunningProgram program(command);
    while (program.runs() && !std::filesystem::exists(sim_)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    kill(program.id(), SIGINT);
    const RunResult run = program.wait();
    EXPECT_EQ(run.exitCode, 130) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("interrupted; nothing was written"));
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(BadSimulation, helpTellsWorldsOptionsAndUnits) {
    const RunResult run = runOffmap({"simulate", "--help"});
    EXPECT_EQ(run.exitCode, 0);
    for (const char* word : {"random_corner", "--mixed-pixels", "--stated-factor", "DEG/S",
                             "rangeimage", "truth.csv.gz"}) {
        EXPECT_THAT(run.out, HasSubstr(word));
    }
}

}  // namespace
