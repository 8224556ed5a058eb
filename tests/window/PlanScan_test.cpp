// SPDX-License-Identifier: BSD-3-Clause
#include "PlanScan.h"

#include "MadeUpFrame.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::window {

namespace {

using test::madeUpFrame;

constexpr double rounding = 1e-9;   // doubles, turned and shifted by some metres
constexpr double roundingF = 1e-5;  // floats of some metres hold 2e-7, through four operations

}  // namespace

TEST(PlanScan, posesStandWhereTheSensorWasSaidAndSeenToStand) {
    const PlanScan plan = planPosesOf(madeUpFrame());
    ASSERT_TRUE(plan.stated);
    EXPECT_NEAR(plan.stated->place.x, 6, rounding);
    EXPECT_NEAR(plan.stated->place.y, 4, rounding);
    EXPECT_NEAR(plan.stated->heading, M_PI / 2, rounding);
    EXPECT_NEAR(plan.stated->covariance(0, 0), 0.04, rounding);
    ASSERT_TRUE(plan.refined);
    EXPECT_NEAR(plan.refined->place.x, 6.3, rounding);
    EXPECT_NEAR(plan.refined->place.y, 4, rounding);
    EXPECT_TRUE(plan.kept.empty());
}

// The correction of the frame is 0.3 m along x.
TEST(PlanScan, keptReturnsStandWhereTheScanWasFoundToBeTaken) {
    live::LiveFrame frame = madeUpFrame();
    const PlanScan plan = planScanOf(frame);
    ASSERT_EQ(plan.kept.size(), 11U);
    EXPECT_NEAR(plan.kept[0].x, 9.3, roundingF);
    EXPECT_NEAR(plan.kept[0].y, 4, roundingF);
    frame.result.alignment.reset();
    EXPECT_NEAR(planScanOf(frame).kept[0].x, 9, roundingF) << "as stated";
}

TEST(PlanScan, returnsThatTheMapKnowsAndLooseOnesAreLeftOut) {
    live::LiveFrame frame = madeUpFrame();
    frame.result.labels[0] = core::PointLabel::Mapped;
    frame.result.labels[1] = core::PointLabel::NotOnVerticalSegment;
    frame.result.labels[2] = core::PointLabel::Orphan;
    EXPECT_EQ(planScanOf(frame).kept.size(), 8U);
}

TEST(PlanScan, ofAScanThatWasNotCorrectedHasNoRefinedPose) {
    live::LiveFrame frame = madeUpFrame();
    frame.reduced.vehicleInMap.reset();
    const PlanScan plan = planPosesOf(frame);
    EXPECT_TRUE(plan.stated);
    EXPECT_FALSE(plan.refined);
}

TEST(PlanScan, ofAScanWithoutPosesIsEmpty) {
    live::LiveFrame frame = madeUpFrame();
    frame.reduced.organized.scan.columns[0].sensor.reset();
    const PlanScan plan = planScanOf(frame);
    EXPECT_FALSE(plan.stated);
    EXPECT_TRUE(plan.kept.empty());
}

TEST(PlanScan, ofAnEmptyFrameIsEmpty) {
    const PlanScan plan = planScanOf({});
    EXPECT_FALSE(plan.stated);
    EXPECT_TRUE(plan.kept.empty());
}

TEST(EllipseOutline, everyCornerIsThatManyDeviationsAway) {
    PlanPose pose{{5, 7}, 0, Eigen::Matrix2d::Zero()};
    pose.covariance << 0.04, 0.01, 0.01, 0.02;
    const auto outline = ellipseOutline(pose, 3);
    ASSERT_GT(outline.size(), 20U);
    const Eigen::Matrix2d information = pose.covariance.inverse();
    for (const auto& corner : outline) {
        const Eigen::Vector2d offset(corner.x - 5, corner.y - 7);
        EXPECT_NEAR(offset.dot(information * offset), 9, rounding);
    }
}

TEST(EllipseOutline, ofAPoseThatIsKnownExactlyOrNotAtAllIsNone) {
    PlanPose pose{{5, 7}, 0, Eigen::Matrix2d::Zero()};
    EXPECT_TRUE(ellipseOutline(pose, 3).empty());
    pose.covariance(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(ellipseOutline(pose, 3).empty());
    pose.covariance << 1, 2, 2, 1;  // an eigenvalue of -1
    EXPECT_TRUE(ellipseOutline(pose, 3).empty());
}

}  // namespace offmap::window
