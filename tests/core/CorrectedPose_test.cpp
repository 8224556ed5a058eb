// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace offmap::core {

using mrpt::poses::CPose3D;

namespace {

constexpr double exactly = 1e-9;  // rounding

ScanColumn columnOf(const CPose3D& vehicle, const CPose3D& mounting) {
    ScanColumn column;
    column.sensorInVehicle = mounting.asTPose();
    column.sensor = SensorPose{vehicle + mounting, Eigen::Matrix3d::Zero()};
    return column;
}

const CPose3D vehicle(3, 4, 0.2, 0.5, 0, 0);
const CPose3D mounting(0.3, -0.1, 1.2, 1.1, 0.3, -0.2);

PoseCorrection by(double dx, double dy, double turn, double leanX = 0, double leanY = 0) {
    PoseCorrection correction;
    correction.pivot = {2, 5};
    correction.mean << dx, dy, turn, leanX, leanY;
    correction.covariance =
        Vector5(0.01 * 0.01, 0.02 * 0.02, 1e-6, 4e-6, 9e-6).asDiagonal().toDenseMatrix();
    return correction;
}

void expectSame(const CPose3D& a, const CPose3D& b, double tolerance) {
    EXPECT_NEAR(a.distanceTo(b), 0, tolerance) << a << b;
    EXPECT_NEAR((a.getRotationMatrix().asEigen() - b.getRotationMatrix().asEigen()).norm(), 0,
                tolerance)
        << a << b;
}

}  // namespace

TEST(CorrectedSensor, ofNoCorrectionIsWhereItWas) {
    const ScanColumn column = columnOf(vehicle, mounting);
    expectSame(correctedSensor(by(0, 0, 0), column), column.sensor->sensorInMap, exactly);
    expectSame(correctedVehicle(by(0, 0, 0), column).mean, vehicle, exactly);
}

TEST(CorrectedSensor, putsPointsWhereTheCorrectionDoes) {
    const ScanColumn column = columnOf(vehicle, mounting);
    const PoseCorrection correction = by(0.2, -0.1, 0.15, 0.01, -0.02);
    const CPose3D corrected = correctedSensor(correction, column);
    for (const mrpt::math::TPoint3D local : {mrpt::math::TPoint3D{4, 1, 1.5}, {-2, 3, -1}}) {
        const auto seen = column.sensor->sensorInMap.composePoint(local);
        const auto& from = column.sensor->sensorInMap;
        const auto place = correction.apply(
            placeOf(column), {{seen.x - from.x(), seen.y - from.y()}, seen.z - from.z()});
        const auto truly = corrected.composePoint(local);
        // apply() is of first order in the lean of 0.022: half its square, times 4.5 m at most.
        EXPECT_NEAR(truly.x, place.x, 0.0012);
        EXPECT_NEAR(truly.y, place.y, 0.0012);
    }
}

TEST(CorrectedSensor, turnsWithTheWorld) {
    const CPose3D world(-7, 2, 0, 2.2, 0, 0);
    const PoseCorrection correction = by(0.2, -0.1, 0.15, 0.01, -0.02);
    PoseCorrection elsewhere = correction;
    const auto pivot = world.composePoint({correction.pivot.x, correction.pivot.y, 0});
    elsewhere.pivot = {pivot.x, pivot.y};
    const auto shift = world.rotateVector({correction.mean[0], correction.mean[1], 0});
    elsewhere.mean[0] = shift.x;
    elsewhere.mean[1] = shift.y;
    expectSame(correctedSensor(elsewhere, columnOf(world + vehicle, mounting)),
               world + correctedSensor(correction, columnOf(vehicle, mounting)), exactly);
}

TEST(CorrectedVehicle, carriesTheSensorToItsCorrectedPlace) {
    const ScanColumn column = columnOf(vehicle, mounting);
    const PoseCorrection correction = by(0.2, -0.1, 0.15, 0.01, -0.02);
    const CPose3D sensor = correctedVehicle(correction, column).mean + mounting;
    const CPose3D expected = correctedSensor(correction, column);
    EXPECT_NEAR(sensor.x(), expected.x(), exactly);
    EXPECT_NEAR(sensor.y(), expected.y(), exactly);
    // The vehicle keeps its height: the sensor's goes with lean times lever, 0.02 * 0.32 m.
    EXPECT_NEAR(sensor.z(), expected.z(), 0.007);
    EXPECT_NEAR(correctedVehicle(correction, column).mean.z(), vehicle.z(), exactly);
}

// Rolling is to the right, pitching is downward, of a vehicle that looks anywhere.
TEST(CorrectedVehicle, leansAsItsRollAndPitchSay) {
    for (const double yaw : {0.0, 1.0, -2.5}) {
        const ScanColumn column = columnOf(CPose3D(3, 4, 0, yaw, 0, 0), mounting);
        const CPose3D leaning = correctedVehicle(by(0, 0, 0, 0.01, -0.02), column).mean;
        // Rotations about two axes in turn: of second order, 0.01 * 0.02.
        EXPECT_NEAR(leaning.roll(), 0.01, 2e-4);
        EXPECT_NEAR(leaning.pitch(), -0.02, 2e-4);
        EXPECT_NEAR(mrpt::math::wrapToPi(leaning.yaw() - yaw), 0, 2e-4);
    }
}

TEST(CorrectedVehicle, turnsAboutThePivotNotAboutItself) {
    const double quarter = M_PI / 2;
    const CPose3D pose =
        correctedVehicle(by(0, 0, quarter), columnOf(CPose3D(3, 5, 0, 0, 0, 0), mounting)).mean;
    EXPECT_NEAR(pose.x(), 2, exactly);
    EXPECT_NEAR(pose.y(), 6, exactly);
    EXPECT_NEAR(pose.yaw(), quarter, exactly);
}

TEST(CorrectedVehicle, isAsUncertainAsTheCorrection) {
    PoseCorrection correction = by(0.1, 0, 0.05);
    correction.pivot = {3, 4};  // the vehicle's own place: a turn does not move it
    const auto pose = correctedVehicle(correction, columnOf(vehicle, mounting));
    const auto& covariance = pose.cov;
    // Of a lean about the sensor, 1.2 m up, the vehicle moves: along by 1.2 m * 3e-3, across alike.
    const double along = std::pow(1.2 * 3e-3, 2), across = std::pow(1.2 * 2e-3, 2);
    const double yaw = 0.55, c = std::cos(yaw), s = std::sin(yaw);
    // Central differences of 1e-5 and a lever of the turn's shift, below a percent.
    EXPECT_NEAR(covariance(0, 0), 1e-4 + c * c * along + s * s * across, 1e-6);
    EXPECT_NEAR(covariance(1, 1), 4e-4 + s * s * along + c * c * across, 4e-6);
    EXPECT_NEAR(covariance(3, 3), 1e-6, 1e-9);
    EXPECT_NEAR(covariance(4, 4), 9e-6, 1e-8);
    EXPECT_NEAR(covariance(5, 5), 4e-6, 1e-8);
    EXPECT_EQ(covariance(2, 2), 0);
    EXPECT_TRUE(isPositiveSemidefinite(covariance.asEigen()));
}

}  // namespace offmap::core
