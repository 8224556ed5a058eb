// SPDX-License-Identifier: BSD-3-Clause
#include "SmallScan.h"

#include <offmap/view/InspectionScene.h>
#include <offmap/view/PoseMarks.h>

#include <gtest/gtest.h>
#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CEllipsoid2D.h>

namespace offmap::view {
namespace {

TEST(PoseMarks, showTheStatedPoseAndTheRefinedOne) {
    SmallScan scan;
    const Palette palette;
    for (auto& column : scan.scan.columns) {
        column.sensor->groundCovariance = Eigen::Vector3d(0.04, 0.01, 0.001).asDiagonal();
    }
    EXPECT_EQ(poseMarksOf(scan.scan, scan.result, 1, palette)->size(), 2U) << "arrow and ellipse";
    auto& correction = scan.result.alignment.emplace().correction;
    correction.mean[0] = 0.5;  // [m] along x
    correction.covariance = core::Matrix5::Identity() * 1e-4;
    const auto marks = poseMarksOf(scan.scan, scan.result, 1, palette);
    EXPECT_EQ(marks->size(), 4U);
    const auto stated = marks->getByClass<mrpt::opengl::CEllipsoid2D>(0);
    const auto refined = marks->getByClass<mrpt::opengl::CEllipsoid2D>(1);
    ASSERT_TRUE(stated && refined);
    EXPECT_NEAR(stated->getPoseX(), 10, 1e-6);
    EXPECT_NEAR(stated->getCovMatrix()(0, 0), 0.04, 1e-6);
    EXPECT_NEAR(refined->getPoseX(), 10.5, 1e-6);
    EXPECT_NEAR(refined->getCovMatrix()(0, 0), 1e-4, 1e-6);
    EXPECT_NEAR(marks->getByClass<mrpt::opengl::CArrow>(1)->getPoseYaw(), 90, 1e-4) << "degrees";
}

TEST(PoseMarks, areNoneForAScanWithoutPoses) {
    SmallScan scan;
    for (auto& column : scan.scan.columns) column.sensor.reset();
    EXPECT_TRUE(poseMarksOf(scan.scan, scan.result, 1, {})->empty());
}

TEST(InspectionScene, holdsReturnsWallsAndPoses) {
    const SmallScan scan;
    const auto scene = inspectionSceneOf(scan.scan, scan.result, scan.map);
    for (const char* name : {"returns", "walls", "sensor", "poses"}) {
        EXPECT_TRUE(scene->getByName(name)) << name;
    }
}

}  // namespace
}  // namespace offmap::view
