// SPDX-License-Identifier: BSD-3-Clause
#include "TurnsInMemory.h"

#include <offmap/live/TrackedPoses.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;

const auto start = mrpt::Clock::fromDouble(1.7e9);
constexpr MotionNoise noise{.speed = 2, .turnRate = 0.5, .sigmaPosition = 0.1, .sigmaHeading = 0.2};

mrpt::poses::CPose3DPDFGaussian estimate(double x, double variance) {
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = {x, 0, 0, 0, 0, 0};
    pose.cov.setIdentity();
    pose.cov *= variance;
    return pose;
}

TEST(TrackedPoses, beginWithTheInitialPoseWhateverTheTime) {
    const TrackedPoses poses({1, 2, 0.5}, noise);
    for (const auto time : {start, start + 1h}) {
        const auto pose = poses.at(time);
        ASSERT_TRUE(pose.vehicleInMap);
        EXPECT_EQ(pose.vehicleInMap->x(), 1);
        EXPECT_NEAR(pose.vehicleInMap->yaw(), 0.5, 1e-12);
        EXPECT_NEAR(pose.groundCovariance(0, 0), 0.01, 1e-12);
        EXPECT_NEAR(pose.groundCovariance(2, 2), 0.04, 1e-12);
    }
}

TEST(TrackedPoses, growUncertainAfterACorrection) {
    TrackedPoses poses({1, 2, 0.5}, noise);
    poses.correct(estimate(3, 1e-4), start);
    EXPECT_EQ(poses.at(start).vehicleInMap->x(), 3);
    EXPECT_NEAR(poses.at(start).groundCovariance(1, 1), 1e-4, 1e-12);
    const auto later = poses.at(start + 100ms);
    EXPECT_NEAR(later.groundCovariance(1, 1), 1e-4 + 0.2 * 0.2, 1e-9);
    EXPECT_NEAR(later.groundCovariance(2, 2), 1e-4 + 0.05 * 0.05, 1e-9);
}

TEST(TrackedPoses, takeNoOlderAndNoBrokenCorrection) {
    TrackedPoses poses({1, 2, 0.5}, noise);
    poses.correct(estimate(3, 1e-4), start);
    poses.correct(estimate(4, 1e-4), start - 1s);
    poses.correct(estimate(std::nan(""), 1e-4), start + 1s);
    EXPECT_EQ(poses.at(start).vehicleInMap->x(), 3);
    EXPECT_EQ(poses.corrections(), 1U);
}

TEST(TrackedPoses, areSettledFromCorrectionToCorrection) {
    TrackedPoses poses({1, 2, 0.5}, noise);
    const auto before = poses.settled();
    EXPECT_EQ(before.until, mrpt::Clock::time_point::max());
    poses.correct(estimate(3, 1e-4), start);
    const auto after = poses.settled();
    EXPECT_NE(after.revision, before.revision);
    poses.correct(estimate(4, 1e-4), start - 1s);
    EXPECT_EQ(poses.settled().revision, after.revision) << "which changes nothing";
}

TEST(TrackedPoses, refuseWhatIsNotFinite) {
    EXPECT_THROW(TrackedPoses({std::nan(""), 0, 0}, noise), std::invalid_argument);
    EXPECT_THROW(TrackedPoses({0, 0, 0}, {.speed = -1}), std::invalid_argument);
}

/// Clouds of a robot that drives through the office at 0.5 m/s and turns at 20 degrees a second.
class Drive : public ScanSource {
 public:
    Drive() { truth.reserve(20); }  // it is read while it grows

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override {
        if (truth.size() == 20 || stop.stop_requested()) return std::nullopt;
        robot_.pose = robot_.pose + mrpt::poses::CPose3D(0.05, 0, 0, mrpt::DEG2RAD(2.0), 0, 0);
        robot_.wait(0.1);
        truth.push_back(robot_.pose);
        return ArrivedTurn{{robot_.cloud()}, truth.size() - 1, std::chrono::steady_clock::now()};
    }
    SourceHealth health() const override { return {}; }
    bool waits() const override { return true; }

    std::vector<mrpt::poses::CPose3D> truth;

 private:
    test::SimulatedRobot robot_;
};

// Each scan tells its pose to about a centimetre (see the accuracy benchmark): five of those.
TEST(TrackedPoses, followARobotThroughTheOffice) {
    const auto poses = std::make_shared<TrackedPoses>(mrpt::math::TPose2D(2, 2.5, 0.3),
                                                      MotionNoise{.speed = 1, .turnRate = 0.6});
    LiveSetup setup = test::officeSetup();
    setup.poses = poses;
    auto source = std::make_unique<Drive>();
    const Drive& drive = *source;
    double worst = 0;  // [m]
    LiveReduction reduction(
        std::move(source), setup,
        {.waiting = 1, .onFrame = [&](const LiveFramePtr& frame) {
             ASSERT_TRUE(frame->reduced.vehicleInMap);
             const auto& found = frame->reduced.vehicleInMap->mean;
             const auto& truth = drive.truth[frame->arrived.number];
             worst = std::max(worst, std::hypot(found.x() - truth.x(), found.y() - truth.y()));
             poses->correct(*frame->reduced.vehicleInMap, frame->reduced.record.time);
         }});
    ASSERT_TRUE(reduction.waitUntilFinished(60s));
    EXPECT_EQ(reduction.failure(), "");
    EXPECT_EQ(poses->corrections(), 20U);
    EXPECT_LT(worst, 0.05);
}

}  // namespace
}  // namespace offmap::live
