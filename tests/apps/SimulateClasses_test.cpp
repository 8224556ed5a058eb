// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateFixture.h"

#include <offmap/rawlog/DecodedPoints.h>
#include <offmap/rawlog/ScanClasses.h>

#include <cmath>

namespace {

using namespace offmap::test;

struct ClassCase {
    std::string scanClass, scanner, world;
    std::string mrptClass;
};

void PrintTo(const ClassCase& one, std::ostream* os) {
    *os << one.scanClass << " " << one.scanner << " in " << one.world;
}

class SimulateClasses : public SimulateFixture, public testing::WithParamInterface<ClassCase> {};

TEST_P(SimulateClasses, logIsReducedAsTheSummaryTells) {
    const ClassCase& one = GetParam();
    Arguments options{"--class", one.scanClass, "--scans", "2"};
    if (!one.scanner.empty()) options.insert(options.end(), {"--scanner", one.scanner});
    const RunResult run = simulate(one.world, options);

    const Path report = folder_ / "report.json";
    const RunResult reduced = follow(run, "reduce", "--strict --report " + report.string());
    ASSERT_EQ(reduced.exitCode, 0) << testing::PrintToString(reduced);

    const auto totals = json(report)["totals"];
    EXPECT_EQ(totals["scans"], 2);
    EXPECT_EQ(json(report)["scans"][0]["class"], one.mrptClass);
    uint64_t points = 0;
    for (const auto& observation : truth()) points += observation.points.size();
    EXPECT_EQ(totals["points"], points);

    const Path scores = folder_ / "score.json";
    const RunResult scored = follow(run, "score", "--json " + scores.string());
    ASSERT_EQ(scored.exitCode, 0) << testing::PrintToString(scored);
    const auto score = json(scores);
    EXPECT_EQ(score["points"], points);
    const auto mapped = score["mapped"]["removed"].get<uint64_t>();
    const auto unmapped =
        score["unmapped"]["points"].get<uint64_t>() - score["unmapped"]["kept"].get<uint64_t>();
    EXPECT_EQ(mapped + unmapped, totals["points_removed"]) << "kept and removed are all";
    EXPECT_GT(score["mapped_on_vertical_segments"]["removed_share"], 0.8);
    EXPECT_GT(score["unmapped"]["kept_share"], 0.8);
}

INSTANTIATE_TEST_SUITE_P(
    All, SimulateClasses,
    testing::Values(ClassCase{"pointcloud", "", "office_room", "CObservationPointCloud"},
                    ClassCase{"pointcloud", "vlp16", "random_room", "CObservationPointCloud"},
                    ClassCase{"velodyne", "", "random_corridor", "CObservationVelodyneScan"},
                    ClassCase{"rotating", "", "corridor", "CObservationRotatingScan"},
                    ClassCase{"sweep", "", "office_room", "CObservation2DRangeScan"},
                    ClassCase{"rangeimage", "", "random_corner", "CObservation3DRangeScan"}));

/// The elevations of a VLP-16's rows are known of its model: no configuration is needed for them.
TEST_F(SimulateFixture, rotatingScansOfAVlp16NeedNoElevations) {
    const RunResult run =
        simulate("office_room", {"--class", "rotating", "--scanner", "vlp16", "--scans", "1"});
    EXPECT_FALSE(std::filesystem::exists(sim_ / "sensor.yaml"));
    const RunResult reduced = follow(run, "reduce", "--strict");
    EXPECT_EQ(reduced.exitCode, 0) << testing::PrintToString(reduced);
}

TEST_F(SimulateFixture, truthIsThatOfTheLogToTheBit) {
    simulate("office_room", {"--class", "velodyne", "--scans", "1"});
    const auto scan = logged<mrpt::obs::CObservationVelodyneScan>().at(0);
    const auto points =
        offmap::rawlog::decodedPoints(*scan, *offmap::rawlog::scanClassOf(*scan, {}), {});
    const auto known = truth().at(0);
    EXPECT_EQ(known.time, scan->timestamp);
    EXPECT_EQ(known.sensor, scan->sensorLabel);
    ASSERT_EQ(known.points.size(), points.size());
    ASSERT_GT(points.size(), 20000U);
    size_t differ = 0, wall = 0, offWall = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        differ += known.points[i].point != points[i];
        // The robot stands at (2, 2.5) and looks along x: to its right is the wall at y = 0.
        if (!known.points[i].mapped || points[i].y > -2 || std::abs(points[i].x) > 1.5F) continue;
        ++wall;
        offWall += std::abs(points[i].y + 2.5F) > 0.1F;  // 5 sigma of 2 cm
    }
    EXPECT_EQ(differ, 0U);
    EXPECT_GT(wall, 1000U);
    EXPECT_EQ(offWall, 0U);
}

}  // namespace
