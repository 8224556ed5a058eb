// SPDX-License-Identifier: BSD-3-Clause
#include "TurnCount.h"

#include "OfficeLogs.h"

#include <offmap/live/RawlogReplay.h>
#include <offmap/rawlog/RawlogReader.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace offmap::window {

namespace {

struct Counted {
    uint64_t told = 0, replayed = 0;
};

class TurnCountTest : public testing::Test {
 protected:
    rawlog::LogSurvey survey() const {
        rawlog::RawlogReader reader(log_);
        return rawlog::surveyLog(reader, config_, std::numeric_limits<uint64_t>::max(), [] {});
    }
    Counted countOf(const test::Observations& observations) {
        test::writeLog(log_, observations);
        const rawlog::LogSurvey found = survey();
        Counted counted;
        counted.told = turnsIn(log_, found, config_, [] {});
        live::RawlogReplay replay(log_, found, config_, std::numeric_limits<double>::infinity());
        while (replay.next({})) ++counted.replayed;
        return counted;
    }

    test::TemporaryFolder folder_;
    const std::filesystem::path log_ = folder_ / "some.rawlog";
    rawlog::Config config_;
};

}  // namespace

TEST_F(TurnCountTest, countsScansAsAReplayDoes) {
    const Counted counted = countOf(test::officeDrive(7));
    EXPECT_EQ(counted.replayed, 7U);
    EXPECT_EQ(counted.told, counted.replayed);
}

TEST_F(TurnCountTest, countsTheTurnsOfSweptScannersAsAReplayDoes) {
    test::SimulatedRobot robot;
    const Counted counted = countOf(test::secondsOf(robot, 2));
    EXPECT_EQ(counted.replayed, 6U) << "of a Velodyne, a cloud and a turned scanner each second";
    EXPECT_EQ(counted.told, counted.replayed);
}

TEST_F(TurnCountTest, imagesWithoutDepthAreNoTurns) {
    test::SimulatedRobot robot;
    test::Observations log{robot.localisation()};
    for (int i = 0; i < 4; ++i) {
        const auto image = robot.depthCamera();
        if (i % 2 == 1) {
            image->hasRangeImage = image->hasPoints3D = false;
            image->rangeImage.resize(0, 0);
            image->resizePoints3DVectors(0);
        }
        robot.wait(0.1);
        log.push_back(image);
    }
    const Counted counted = countOf(log);
    EXPECT_EQ(counted.told, counted.replayed);
}

TEST_F(TurnCountTest, whatSharesALabelWithScansIsNoTurn) {
    test::SimulatedRobot robot;
    const auto imu = robot.imu();
    imu->sensorLabel.clear();
    const Counted counted = countOf({imu, robot.cloud(""), imu, robot.cloud("")});
    EXPECT_EQ(counted.replayed, 2U);
    EXPECT_EQ(counted.told, counted.replayed);
}

TEST_F(TurnCountTest, countingCanBeEnded) {
    test::SimulatedRobot robot;
    test::writeLog(log_, test::secondsOf(robot, 1));
    int entries = 0;
    EXPECT_THROW(turnsIn(log_, survey(), config_,
                         [&] {
                             if (++entries == 3) throw std::runtime_error("enough");
                         }),
                 std::runtime_error);
    EXPECT_EQ(entries, 3);
}

}  // namespace offmap::window
