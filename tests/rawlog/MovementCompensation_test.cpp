// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/SweepScan.h>
#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>

#include <string>

namespace offmap::rawlog {
namespace {

/// What a program does that places a whole turn by one pose.
class PoseAtTheStart : public PoseSource {
 public:
    PoseAtTheStart(const PoseSource& poses, mrpt::Clock::time_point start)
        : lookup_(poses.at(start)) {}
    PoseLookup at(mrpt::Clock::time_point) const override { return lookup_; }

 private:
    PoseLookup lookup_;
};

/// The office, in which a robot turns on the spot at 30 degrees a second and is located 50 times a
/// second, as well as by matching scans: a worse pose widens the gate, which hides part of what is
/// wrong with it.
class MovementCompensation : public testing::Test {
 protected:
    MovementCompensation() {
        const double position = 0.005, yaw = mrpt::DEG2RAD(0.1);  // [m], [rad] sigmas
        robot_.yawRate = mrpt::DEG2RAD(30.0);
        test::SimulatedRobot located = robot_;
        std::vector<StampedPose> poses;
        for (int i = 0; i <= 50; ++i) {
            StampedPose pose = stampedPose(*located.localisation());
            pose.groundCovariance = {position * position, 0, 0, position * position, 0, yaw * yaw};
            poses.push_back(pose);
            located.wait(0.02);
        }
        poses_ = std::make_unique<PoseTrack>(std::move(poses));
    }

    /// Of all returns.
    double removedShare(const Turn& turn, const ScanClass& scanClass, const PoseSource& poses) {
        const core::LineMap map(mapOf(evaluation::officeRoom()));
        // The paper's method takes poses at their word; aligned would mend a part of the error.
        Config config;
        config.reduction.matching.method = core::MatchingMethod::Paper;
        TurnReducer reducer(map, poses, config, OutputClass::Same);
        const TurnRecord record = reducer.reduce(turn, scanClass).record;
        return static_cast<double>(record.removed()) / static_cast<double>(record.counts.returns);
    }

    struct Shares {
        double standing, compensated, atTheStart;
    };

    /// \param still the same turn of a robot that does not move
    Shares sharesOf(const Turn& turn, const Turn& still, const ScanClass& scanClass) {
        const PoseAtTheStart start(*poses_, turn.front()->timestamp);
        const Shares shares{removedShare(still, scanClass, start),
                            removedShare(turn, scanClass, *poses_),
                            removedShare(turn, scanClass, start)};
        RecordProperty("standing", std::to_string(shares.standing));
        RecordProperty("compensated", std::to_string(shares.compensated));
        RecordProperty("atTheStart", std::to_string(shares.atTheStart));
        return shares;
    }

    test::SimulatedRobot robot_, still_;
    std::unique_ptr<PoseTrack> poses_;
};

// The head's turn lasts 0.1 s, the robot turns by 3 degrees meanwhile: 15 cm at 3 m, where a wall
// is seen along it. What looks straight at a wall fits even then.
TEST_F(MovementCompensation, keepsAVlp16TurnOnTheMap) {
    const Shares shares = sharesOf({robot_.vlp16()}, {still_.vlp16()}, VelodyneScan());
    EXPECT_GT(shares.compensated, 0.97 * shares.standing);
    EXPECT_LT(shares.atTheStart, 0.93 * shares.compensated);
}

// 0.8 s, 24 degrees: the turn sees some of the walls twice, or not at all.
TEST_F(MovementCompensation, keepsASweepOnTheMap) {
    const auto asTurn = [](const test::Observations& fans) {
        return Turn(fans.begin(), fans.end());
    };
    const Shares shares =
        sharesOf(asTurn(robot_.sweep(360)), asTurn(still_.sweep(360)), SweepScan());
    EXPECT_GT(shares.compensated, 0.93 * shares.standing);
    EXPECT_LT(shares.atTheStart, 0.5 * shares.compensated);
}

}  // namespace
}  // namespace offmap::rawlog
