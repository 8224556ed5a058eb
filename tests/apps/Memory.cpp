// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <offmap/rawlog/RawlogWriter.h>

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;

class Memory : public ReduceFixture {
 protected:
    /// One scan over and over again, at 10 Hz, with poses in between.
    void writeScans(int count) const {
        SimulatedRobot robot;
        const auto scan = robot.vlp16();
        offmap::rawlog::RawlogWriter writer(in_, {std::nullopt, true});
        for (int i = 0; i < count; ++i) {
            writer.write(*robot.localisation());
            robot.wait(0.1);
            scan->timestamp = robot.now;
            writer.write(*scan);
        }
        writer.publish();
    }

    /// [KiB] largest resident set while so many scans are reduced.
    int64_t peakOf(int scans) const {
        writeScans(scans);
        const auto report = folder_ / "report.json";
        const RunResult run = reduce({"--force", "--report", report, "--quiet"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto totals = nlohmann::json::parse(readFile(report))["totals"];
        EXPECT_EQ(totals["scans"], scans);
        EXPECT_GT(totals["points_removed"], 1000 * scans);
        return run.peakMemory;
    }

    /// [KiB] likewise while a log of so many scans is looked into.
    int64_t peakOfInfo(int scans) const {
        writeScans(scans);
        const RunResult run = runOffmap({"info", in_, "--json", "--quiet"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_THAT(run.out, testing::HasSubstr("\"scans\": " + std::to_string(scans)));
        return run.peakMemory;
    }
};

// The figure begins with what this program held when it forked.
int64_t ownPeak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST_F(Memory, doesNotGrowWithTheLog) {
    const int64_t few = peakOf(200);
    EXPECT_LT(ownPeak(), few);
    const int64_t many = peakOf(2000);
    EXPECT_LT(static_cast<double>(many), 1.1 * static_cast<double>(few)) << few << " KiB before";
}

TEST_F(Memory, ofInfoDoesNotGrowWithTheLog) {
    const int64_t few = peakOfInfo(200);
    EXPECT_LT(ownPeak(), few);
    const int64_t many = peakOfInfo(2000);
    EXPECT_LT(static_cast<double>(many), 1.1 * static_cast<double>(few)) << few << " KiB before";
}

}  // namespace
