// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using nlohmann::json;

class Report : public ReduceFixture {
 protected:
    json reduceAndRead(const Arguments& more = {}) {
        Arguments arguments{"--report", report_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = reduce(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return json::parse(readFile(report_));
    }

    static uint64_t returnsIn(const Path& log) {
        uint64_t returns = 0;
        for (const auto& obs : observationsOf(log)) {
            if (is3dScan(*obs)) returns += returnsOf(*obs).size();
        }
        return returns;
    }

    const Path report_ = folder_ / "report.json";
};

TEST_F(Report, totalsAreTheSumsOfTheScans) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 3));
    const json report = reduceAndRead();
    const json& totals = report["totals"];
    EXPECT_EQ(totals["scans"], 9);  // a VLP-16's, a cloud and a sweep a second
    ASSERT_EQ(report["scans"].size(), 9U);
    for (const char* key : {"points", "points_on_vertical_segments", "points_removed",
                            "points_removed_by_ray", "points_removed_by_extension", "columns"}) {
        uint64_t sum = 0;
        for (const json& scan : report["scans"]) sum += scan.at(key).get<uint64_t>();
        EXPECT_EQ(totals.at(key), sum) << key;
    }
    EXPECT_GT(totals["points_removed"], 1000);
    for (const auto& [reason, points] : totals["points_kept_by_reason"].items()) {
        uint64_t sum = 0;
        for (const json& scan : report["scans"]) {
            sum += scan["points_kept_by_reason"].at(reason).get<uint64_t>();
        }
        EXPECT_EQ(points, sum) << reason;
    }
    EXPECT_TRUE(totals["scans_not_reduced"].is_object());
    EXPECT_GT(totals["reduce_ms_median"].get<double>(), 0);
    EXPECT_GT(report["stage_seconds"]["reduce"].get<double>(), 0);
}

TEST_F(Report, countsAreThoseOfTheLogs) {
    SimulatedRobot robot;
    writeLog(in_, inFrames(secondsOf(robot, 1)));
    const json totals = reduceAndRead()["totals"];
    EXPECT_EQ(totals["points"], returnsIn(in_));
    EXPECT_EQ(totals["points_removed"], returnsIn(in_) - returnsIn(out_));
    EXPECT_LE(totals["points_removed"], totals["points_on_vertical_segments"]);
}

TEST_F(Report, onVerticalSegmentsIsRemovedOrKeptForAReason) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    const json totals = reduceAndRead()["totals"];
    uint64_t kept = totals["points_kept_off_wall"];
    for (const auto& [reason, points] : totals["points_kept_by_reason"].items()) {
        kept += points.get<uint64_t>();
    }
    const uint64_t onSegments = totals["points_removed"].get<uint64_t>() -
                                totals["points_removed_by_point"].get<uint64_t>();
    EXPECT_EQ(totals["points_on_vertical_segments"], onSegments + kept);
}

TEST_F(Report, returnsThatAreNoPointsAreCountedApart) {
    SimulatedRobot robot;
    const auto cloud = robot.cloud();
    const size_t good = cloud->pointcloud->size();
    cloud->pointcloud->insertPoint(NAN, 1, 1);
    cloud->pointcloud->insertPoint(0, 0, 0);
    cloud->pointcloud->insertPoint(0, 0, 0);
    writeLog(in_, Observations{robot.localisation(), cloud});
    const json totals = reduceAndRead()["totals"];
    EXPECT_EQ(totals["points"], good);
    EXPECT_EQ(totals["points_not_finite"], 1);
    EXPECT_EQ(totals["slots_without_return"], 2);
}

TEST_F(Report, tellsWhatWasReducedWithWhat) {
    writeLog(in_, smallLog());
    const json report = reduceAndRead({"--set", "vertical.max_tilt_deg=4.5"});
    EXPECT_EQ(report["scans"][0]["class"], "CObservationPointCloud");
    EXPECT_EQ(report["scans"][0]["sensor"], "CLOUD");
    EXPECT_EQ(report["scans"][0]["entry"], 1);
    EXPECT_EQ(report["input"], in_.string());
    EXPECT_EQ(report["map"]["file"], map_.string());
    EXPECT_EQ(report["parameters"]["vertical.max_tilt_deg"].dump().find("4.5") != std::string::npos,
              true);
    EXPECT_EQ(report["warnings"], json::array());
}

TEST_F(Report, labelOfAnyBytesIsStillJson) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.localisation(), robot.cloud("\"quoted\"\n\xff")});
    EXPECT_EQ(reduceAndRead()["totals"]["scans"], 1);
}

}  // namespace
