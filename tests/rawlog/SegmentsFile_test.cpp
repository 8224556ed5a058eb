// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SegmentsFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <numbers>

namespace offmap::rawlog {
namespace {

using testing::HasSubstr;

constexpr const char* header =
    "scan,entry,sensor,time_s,column,azimuth_deg,points,z_min_m,z_max_m,tilt_deg,measured_min_m,"
    "measured_max_m,predicted_min_m,predicted_max_m,residual,verdict,reason,wall,"
    "points_removed,suspect\n";

/// Two columns, the second without a pose, and a segment in each.
struct SmallTurn {
    ReducedTurn turn;
    core::ReductionResult result;

    explicit SmallTurn(const std::string& label) {
        core::ScanColumn placed, lost;
        placed.azimuth = std::numbers::pi_v<float> / 2;
        placed.time = mrpt::Clock::fromDouble(1.7e9);
        placed.sensor = core::SensorPose{mrpt::poses::CPose3D(1, 2, 1.5, 0, 0, 0)};
        lost.azimuth = -std::numbers::pi_v<float> / 4;
        lost.time = mrpt::Clock::fromDouble(1.7e9 + 0.25);
        lost.sensorInVehicle.z = 0.7;
        turn.organized.scan.columns = {placed, lost};
        turn.record.entry = 7;
        turn.record.label = label;
        turn.returnsPerSegment = {12, 3};
        turn.removedPerSegment = {11, 0};
        result.segments = {{0, 0, 10, {4, -1.2}, {4, 0.9}, mrpt::DEG2RAD(1.5), {0, 4}},
                           {1, 10, 13, {2.5, -0.70004}, {2.5, 0.25}, 0, {2, -2}}};
        core::SegmentMatch mapped;
        mapped.verdict = core::Verdict::MappedByRay;
        mapped.reason = core::KeepReason::None;
        mapped.wall = 17;
        mapped.measured = {3.98, 4.02};
        mapped.predicted = core::Interval(3.9, 4.0996);
        mapped.residual = -0.0001;
        core::SegmentMatch kept;
        kept.measured = {2.5, 2.5};
        result.matches = {mapped, kept};
    }
};

std::string fileOf(const std::vector<SmallTurn>& turns) {
    const test::TemporaryFolder folder;
    SegmentsFile file(folder / "segments.csv", {});
    for (uint64_t scan = 0; scan < turns.size(); ++scan) {
        file.add(SegmentsFile::rowsOf(scan, turns[scan].turn, turns[scan].result));
    }
    file.publish();
    return test::readFile(folder / "segments.csv");
}

TEST(SegmentsFile, rowTellsAllOfASegment) {
    EXPECT_EQ(fileOf({SmallTurn("LIDAR")}),
              std::string(header) +
                  "0,7,LIDAR,1700000000.000000,0,90.000,12,0.300,2.400,1.500,3.980,4.020,3.900,"
                  "4.100,0.000,mapped_by_ray,,17,11,\n"
                  "0,7,LIDAR,1700000000.250000,1,-45.000,3,0.000,0.950,0.000,2.500,2.500,,,,kept,"
                  "no_pose,,0,\n");
}

TEST(SegmentsFile, rowTellsIfItsScanIsSuspect) {
    SmallTurn small("LIDAR");
    small.turn.record.health.suspect = core::Suspicion::FewMatches;
    EXPECT_THAT(fileOf({small}), HasSubstr(",no_pose,,0,few_matches\n"));
}

TEST(SegmentsFile, scansAreNumbered) {
    EXPECT_THAT(fileOf({SmallTurn("A"), SmallTurn("B")}), HasSubstr("\n1,7,B,"));
}

TEST(SegmentsFile, labelIsQuotedWhereItMustBe) {
    EXPECT_THAT(fileOf({SmallTurn("front, \"left\"")}),
                HasSubstr("0,7,\"front, \"\"left\"\"\",1700000000.000000,0,"));
    EXPECT_THAT(fileOf({SmallTurn("two\nlines")}), HasSubstr("0,7,\"two\nlines\",17"));
    EXPECT_THAT(fileOf({SmallTurn("with space")}), HasSubstr("0,7,with space,17"));
}

TEST(SegmentsFile, logWithoutScansGivesTheHeader) { EXPECT_EQ(fileOf({}), header); }

/// A wall at x = 5, 21 points of it seen from (0, 0, 1): 0.5 to 1.5 m above the floor.
TEST(SegmentsFile, agreesWithAScanSolvedByHand) {
    const core::LineMap map({{{{-5, -5}, {-5, 5}}, 0.02}, {{{5, -5}, {5, 5}}, 0.02}});
    const test::DrivenVehicle poses{mrpt::poses::CPose3D()};
    auto cloud = std::make_shared<mrpt::obs::CObservationPointCloud>();
    cloud->sensorPose = mrpt::poses::CPose3D(0, 0, 1, 0, 0, 0);
    cloud->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (int i = 0; i <= 20; ++i) {
        cloud->pointcloud->insertPoint(5, 0, -0.5F + 0.05F * static_cast<float>(i));
    }
    Config config;
    config.reduction.matching.method = core::MatchingMethod::Paper;
    TurnReducer reducer(map, poses, config, OutputClass::Same);
    SmallTurn small("CLOUD");
    small.turn = reducer.reduce({cloud}, *scanClassOf(*cloud, {}));
    small.turn.record.label = "CLOUD";
    small.result = reducer.result();
    ASSERT_EQ(small.result.segments.size(), 1U);
    const std::string file = fileOf({small});
    EXPECT_THAT(file, HasSubstr(",21,0.500,1.500,0.000,"));
    // 5 m +- the map's 2 cm times the sigma factor of 2
    EXPECT_THAT(file, HasSubstr(",4.960,5.040,0.000,mapped_by_ray,,1,21,\n"));
}

}  // namespace
}  // namespace offmap::rawlog
