// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;

// What a wall of the office leaves after the default's reduction, each preset must find as well.
TEST_F(ReduceFixture, everyPresetReducesTheOffice) {
    SimulatedRobot robot;
    writeLog(in_, oneSecondOf(robot));
    const auto report = folder_ / "report.json";
    for (const char* preset : {"default", "indoor", "outdoor", "vlp16"}) {
        SCOPED_TRACE(preset);
        const auto file = sourceFile("config") / (std::string(preset) + ".yaml");
        const RunResult run = reduce({"--config", file, "--report", report, "--force"});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(run.err, "");
        const auto totals = nlohmann::json::parse(readFile(report))["totals"];
        // The office's objects and the room behind the door hold less than half of all.
        EXPECT_GT(totals["points_removed"].get<double>(),
                  0.5 * totals["points_on_vertical_segments"].get<double>());
    }
}

TEST_F(ReduceFixture, defaultPresetIsWhatHoldsWithoutOne) {
    SimulatedRobot robot;
    writeLog(in_, oneSecondOf(robot));
    ASSERT_EQ(reduce().exitCode, 0);
    const std::string without = readFile(out_);
    ASSERT_EQ(reduce({"--config", sourceFile("config/default.yaml"), "--force"}).exitCode, 0);
    EXPECT_TRUE(readFile(out_) == without);
}

}  // namespace
