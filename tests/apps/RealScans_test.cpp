// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "RawlogEdit.h"
#include "ReduceFixture.h"

#include <offmap/maps/TextMap.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace offmap::test;
using mrpt::math::TPoint3D;
using testing::HasSubstr;

const char* const vlp16Sample = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";

/// A return's point in the frame of the vehicle, from what returnsOf() tells.
TPoint3D inVehicle(const mrpt::obs::CObservation& obs, const Return& hit) {
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs)) {
        const double angle = scan->getScanAngle(static_cast<size_t>(hit[0]));
        return scan->sensorPose.composePoint(
            {hit[1] * std::cos(angle), hit[1] * std::sin(angle), 0});
    }
    const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(obs);
    return cloud.sensorPose.composePoint({hit[0], hit[1], hit[2]});
}

struct Share {
    double part = 0, all = 0;
    double value() const { return part / all; }
};

/// Judged by geometry alone, without a truth.
struct Judgement {
    Share nearRemoved;  ///< of the returns within 6 cm of a wall, floor and ceiling apart
    Share farKept;      ///< of those more than 50 cm off every wall
};

class RealScans : public ReduceFixture {
 protected:
    RunResult reduceRoom(const std::string& name, const Arguments& more = {}) {
        return reduceLog(sharedData("room/" + name), more);
    }

    Judgement judge(const mrpt::poses::CPose2D& vehicleInMap) const {
        const auto walls = offmap::maps::readTextMap(map_, 0);
        const Observations before = observationsOf(in_), after = observationsOf(out_);
        Judgement judgement;
        EXPECT_EQ(after.size(), before.size());
        for (size_t i = 0; i < before.size(); ++i) {
            const auto left = returnsOf(*after.at(i));
            for (const Return& hit : returnsOf(*before[i])) {
                const TPoint3D point = inVehicle(*before[i], hit);
                if (point.z < 0.15 || point.z > 2.85) continue;
                mrpt::math::TPoint2D onGround;
                vehicleInMap.composePoint(mrpt::math::TPoint2D(point.x, point.y), onGround);
                double off = 9;  // [m]
                for (const auto& wall : walls) off = std::min(off, wall.line.distance(onGround));
                const bool kept = std::binary_search(left.begin(), left.end(), hit);
                if (off < 0.06) judgement.nearRemoved.part += !kept, ++judgement.nearRemoved.all;
                if (off > 0.5) judgement.farKept.part += kept, ++judgement.farKept.all;
            }
        }
        return judgement;
    }

    void expectWellReduced(const std::string& name, const mrpt::poses::CPose2D& vehicleInMap) {
        const RunResult run = reduceRoom(name);
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(run.err, "") << "no warning is due";
        const Judgement judgement = judge(vehicleInMap);
        EXPECT_GT(judgement.nearRemoved.all, 5'000);
        EXPECT_GT(judgement.farKept.all, 5'000);
        EXPECT_GE(judgement.nearRemoved.value(), 0.75);
        EXPECT_GE(judgement.farKept.value(), 0.995);
    }
};

class RealOffice : public RealScans {
 protected:
    void SetUp() override {
        OFFMAP_NEEDS_SHARED_DATA()
        map_ = sharedData("room/room.lines");
    }
};

TEST_F(RealOffice, firstTurnLosesItsWallsAlone) {
    expectWellReduced("room1.rawlog", {});
    expectRawlogEditReads(out_, in_);
}

TEST_F(RealOffice, secondTurnLosesItsWallsAlone) {
    expectWellReduced("room2.rawlog", {1.983, 0.061, 0.713});
    expectRawlogEditReads(out_, in_);
}

TEST_F(RealOffice, cloudLosesItsWallsAlone) {
    expectWellReduced("room1_points.rawlog", {});
    expectRawlogEditReads(out_, in_);
}

TEST_F(RealOffice, poseThatLiesIsWarnedOf) {
    const RunResult run = reduceRoom("room2_bad_pose.rawlog");
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, testing::AllOf(HasSubstr("warning: 1 of 1 scans contradict"),
                                        HasSubstr("check the poses")));
    const RunResult paper = reduceRoom("room2_bad_pose.rawlog", {"--method", "paper", "--force"});
    EXPECT_EQ(paper.exitCode, 0) << testing::PrintToString(paper);
    EXPECT_THAT(paper.err, testing::AllOf(HasSubstr("warning: only "), HasSubstr("were removed"),
                                          HasSubstr("check the poses")));
}

TEST_F(RealScans, outdoorSampleIsReduced) {
    map_ = sourceFile("share/maps/vlp16_demo.lines");
    const Path removed = folder_ / "removed.rawlog";
    const RunResult run = reduceLog(vlp16Sample, {"--config", sourceFile("config/vlp16.yaml"),
                                                  "--pose", "0,0,0", "--removed", removed});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_EQ(run.err, "");
    expectRawlogEditReads(out_, in_);
    expectRawlogEditReads(removed, in_);
    const auto all = returnsOf(*observationsOf(in_).at(0));
    const auto gone = returnsOf(*observationsOf(removed).at(0));
    EXPECT_EQ(all.size(), 22'591U);
    // share/maps/README.md counts what stands on the drawn walls: 421 returns at least three in a
    // column, 1,388 in all.
    EXPECT_GT(gone.size(), 200U);
    EXPECT_LT(gone.size(), 1'388U);
}

TEST_F(RealScans, rawlogEditReadsEveryOutput) {
    map_ = folder_ / "office.lines";
    in_ = folder_ / "in.rawlog";
    SimulatedRobot robot;
    const Observations log = secondsOf(robot, 1);
    const Path removed = folder_ / "removed.rawlog";
    for (const char* output : {"same", "points"}) {
        for (const bool frames : {false, true}) {
            frames ? writeLog(in_, inFrames(log)) : writeLog(in_, log);
            ASSERT_EQ(reduce({"--removed", removed, "--output", output, "--force"}).exitCode, 0);
            expectRawlogEditReads(out_, in_);
            expectRawlogEditReads(removed, in_);
        }
    }
}

}  // namespace
