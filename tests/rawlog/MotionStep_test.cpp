// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/MotionStep.h>

#include <gtest/gtest.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussianInf.h>
#include <mrpt/poses/CPosePDFParticles.h>
#include <mrpt/poses/CPosePDFSOG.h>

#include <limits>

namespace offmap::rawlog {
namespace {

using core::PoseFault;
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CActionRobotMovement3D;
using mrpt::poses::CPose2D;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

mrpt::math::CMatrixDouble33 covarianceOf(double xx, double xy, double yawYaw) {
    mrpt::math::CMatrixDouble33 covariance;
    covariance.setZero();
    covariance(0, 0) = covariance(1, 1) = xx;
    covariance(0, 1) = covariance(1, 0) = xy;
    covariance(2, 2) = yawYaw;
    return covariance;
}

CActionRobotMovement2D inPlane(const mrpt::poses::CPosePDF& increment) {
    CActionRobotMovement2D movement;
    const mrpt::poses::CPosePDF::Ptr copy(dynamic_cast<mrpt::poses::CPosePDF*>(increment.clone()));
    movement.poseChange = copy;
    return movement;
}

CActionRobotMovement2D gaussian(const CPose2D& mean, const mrpt::math::CMatrixDouble33& cov) {
    return inPlane(mrpt::poses::CPosePDFGaussian(mean, cov));
}

template <class... Actions>
std::optional<MotionStep> movementAmong(const Actions&... actions) {
    CActionCollection collection;
    (collection.insert(actions), ...);
    return movementOf(collection);
}

TEST(MotionStep, gaussianInThePlaneIsTakenOver) {
    const auto step = movementAmong(gaussian({0.5, -0.1, 0.2}, covarianceOf(4e-4, 1e-4, 9e-4)));
    ASSERT_TRUE(step);
    EXPECT_EQ(step->vehicleInPrevious.x, 0.5);
    EXPECT_EQ(step->vehicleInPrevious.y, -0.1);
    EXPECT_NEAR(step->vehicleInPrevious.yaw, 0.2, 1e-15);  // through a matrix and back
    EXPECT_EQ(step->groundCovariance, (GroundTriangle{4e-4, 1e-4, 0, 4e-4, 0, 9e-4}));
    EXPECT_FALSE(step->fault);
    EXPECT_FALSE(step->time);
}

TEST(MotionStep, particlesBecomeTheirMeanAndCovariance) {
    mrpt::poses::CPosePDFParticles particles(2);
    particles.m_particles[0].d = {0.4, 0, 0};
    particles.m_particles[1].d = {0.6, 0, 0};
    const auto step = movementAmong(inPlane(particles));
    ASSERT_TRUE(step);
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(step->vehicleInPrevious.x, 0.5, rounding);
    EXPECT_NEAR(step->groundCovariance[0], 0.01, rounding);  // both 0.1 m off the mean
    EXPECT_FALSE(step->fault);
}

TEST(MotionStep, movementInSpaceIsTakenOver) {
    CActionRobotMovement3D movement;
    movement.poseChange.mean = {0.5, 0.1, 0.02, 0.2, 0.05, -0.03};
    movement.poseChange.cov.setZero();
    for (int i = 0; i < 6; ++i) movement.poseChange.cov(i, i) = 1e-4 * (i + 1);
    const auto step = movementAmong(movement);
    ASSERT_TRUE(step);
    const mrpt::math::TPose3D mean(0.5, 0.1, 0.02, 0.2, 0.05, -0.03);
    constexpr double rounding = 1e-12;  // angles go into a matrix and back
    for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(step->vehicleInPrevious[i], mean[i], rounding);
    EXPECT_EQ(step->groundCovariance, (GroundTriangle{1e-4, 0, 0, 2e-4, 0, 4e-4}));
}

TEST(MotionStep, firstMovementCounts) {
    const auto step = movementAmong(gaussian({1, 0, 0}, covarianceOf(1e-4, 0, 1e-4)),
                                    gaussian({2, 0, 0}, covarianceOf(1e-4, 0, 1e-4)));
    ASSERT_TRUE(step);
    EXPECT_EQ(step->vehicleInPrevious.x, 1);
}

TEST(MotionStep, withoutMovementThereIsNone) { EXPECT_FALSE(movementOf(CActionCollection())); }

TEST(MotionStep, whatIsNotFiniteIsTold) {
    const auto covariance = covarianceOf(1e-4, 0, 1e-4);
    EXPECT_EQ(movementAmong(gaussian({nan, 0, 0}, covariance))->fault, PoseFault::NotFinite);
    EXPECT_EQ(movementAmong(gaussian({1, 0, 0}, covarianceOf(nan, 0, 1e-4)))->fault,
              PoseFault::NotFinite);
    CActionRobotMovement3D movement;
    movement.poseChange.cov(2, 2) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(movementAmong(movement)->fault, PoseFault::NotFinite);
}

TEST(MotionStep, covarianceThatIsNoneIsTold) {
    EXPECT_EQ(movementAmong(gaussian({1, 0, 0}, covarianceOf(1e-4, 2e-4, 1e-4)))->fault,
              PoseFault::NotPsd);
    CActionRobotMovement3D movement;
    movement.poseChange.cov.setIdentity();
    movement.poseChange.cov(2, 2) = -1;
    EXPECT_EQ(movementAmong(movement)->fault, PoseFault::NotPsd);
}

// MRPT gives sets of nothing a mean of zero: a robot that stood.
TEST(MotionStep, setsOfNothingAreFaulty) {
    EXPECT_EQ(movementAmong(inPlane(mrpt::poses::CPosePDFParticles(0)))->fault,
              PoseFault::NotFinite);
    EXPECT_EQ(movementAmong(inPlane(mrpt::poses::CPosePDFSOG(0)))->fault, PoseFault::NotFinite);
}

TEST(MotionStep, densityWithoutInformationIsFaulty) {
    mrpt::poses::CPosePDFGaussianInf knowsNothing;
    knowsNothing.cov_inv.setZero();
    EXPECT_TRUE(movementAmong(inPlane(knowsNothing))->fault);
}

TEST(MotionStep, movementWithoutDensityIsFaulty) {
    CActionCollection collection;
    collection.insert(CActionRobotMovement2D());
    std::dynamic_pointer_cast<CActionRobotMovement2D>(collection.get(0))->poseChange.reset();
    EXPECT_EQ(movementOf(collection)->fault, PoseFault::NotFinite);
}

}  // namespace
}  // namespace offmap::rawlog
