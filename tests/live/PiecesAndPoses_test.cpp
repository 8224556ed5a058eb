// SPDX-License-Identifier: BSD-3-Clause
#include "TurnsInPiecesFixture.h"

#include <offmap/live/LivePoses.h>
#include <offmap/live/TrackedPoses.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PoseTrack.h>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using test::CountedPoses;
using test::lookupsOfTurn;
using test::officeSetup;
using test::packetsOfTurn;
using test::pieceOf;
using test::pieceSize;
using test::PiecewiseSource;
using Scan = test::VelodyneObservation;

using PiecesAndPoses = TurnsInPieces;

/// Poses 30 ms apart of a robot that stands, but less certain from pose to pose.
rawlog::StampedPose poseNumber(int i) {
    rawlog::StampedPose pose;
    pose.time = test::SimulatedRobot().now + i * 30ms;
    pose.vehicleInMap = test::SimulatedRobot().pose.asTPose();
    const double sigma = 0.01 + 0.005 * i;  // [m]
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance.diagonal() << sigma * sigma, sigma * sigma, 1e-4;
    pose.groundCovariance = rawlog::triangleOf(covariance);
    return pose;
}

// A column lasts 55.296 us: 1085 of them are over when the last pose comes before the turn is
// complete, and perhaps one more by what stamps are rounded to.
TEST_F(PiecesAndPoses, waitForPosesThatComeMeanwhile) {
    const auto coming = std::make_shared<LivePoses>(0.5);
    countLookups(coming);
    auto source = std::make_unique<PiecewiseSource>(1);
    std::vector<rawlog::StampedPose> poses;
    const auto come = [&](int i) {
        poses.push_back(poseNumber(i));
        coming->add(poses.back());
    };
    source->handOverPieces = [&](PiecewiseSource& from, uint64_t turn) {
        for (int i = 0; i < 3; ++i) {
            come(i);
            for (size_t first = 25 * size_t(i); first < 25 * size_t(i + 1); first += pieceSize) {
                if (first + pieceSize < packetsOfTurn) {
                    from.give(pieceOf(*from.scan(turn), turn, first));
                }
            }
        }
    };
    size_t before = 0;
    source->beforeTurn = [&](uint64_t) {
        EXPECT_TRUE(poses_->waitFor(1085));
        std::this_thread::sleep_for(20ms);  // in which others would be taken in
        before = poses_->lookups();
        come(3);
        come(4);
    };
    const auto frames = framesOf(std::move(source));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_LE(before, 1087U);
    EXPECT_EQ(poses_->lookups(), lookupsOfTurn);
    const rawlog::PoseTrack track(poses, 0.5);
    expectAsWhole(*frames.front(), setup_);
    for (const core::ScanColumn& column : frames.front()->reduced.organized.scan.columns) {
        core::ScanColumn expected;
        rawlog::placeColumn(expected, track.at(column.time),
                            mrpt::poses::CPose3D(column.sensorInVehicle));
        ASSERT_EQ(column.sensor->groundCovariance, expected.sensor->groundCovariance);
    }
}

/// The poses that a tracked robot's turns were found at. \param pieces whether they come
std::vector<mrpt::math::TPose3D> trackedThrough(bool pieces) {
    const auto tracked =
        std::make_shared<TrackedPoses>(mrpt::math::TPose2D(2.03, 2.48, 0.31), MotionNoise{});
    const auto counted = std::make_shared<CountedPoses>(tracked);
    LiveSetup setup = officeSetup();
    setup.poses = counted;
    auto source = std::make_unique<PiecewiseSource>(5);
    if (pieces) {
        awaitAll(*source, *counted);
    } else {
        source->handOverPieces = [](PiecewiseSource&, uint64_t) {};
    }
    std::vector<mrpt::math::TPose3D> found;
    LiveReduction reduction(std::move(source), setup, {.onFrame = [&](const LiveFramePtr& frame) {
                                ASSERT_TRUE(frame->reduced.vehicleInMap);
                                found.push_back(frame->reduced.vehicleInMap->mean.asTPose());
                                tracked->correct(*frame->reduced.vehicleInMap,
                                                 frame->reduced.record.time);
                            }});
    EXPECT_TRUE(reduction.waitUntilFinished(longEnough));
    EXPECT_EQ(counted->lookups(), 5 * lookupsOfTurn) << "no correction came between";
    return found;
}

TEST_F(PiecesAndPoses, ofATrackedRobotAreFoundWhereTheWholeOnesAre) {
    const auto found = trackedThrough(true);
    EXPECT_EQ(found.size(), 5U);
    EXPECT_EQ(found, trackedThrough(false));
}

}  // namespace
}  // namespace offmap::live
