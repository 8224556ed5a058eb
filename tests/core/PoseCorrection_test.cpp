// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/PoseCorrection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double quarter = std::numbers::pi / 2;  // [rad]

PoseCorrection by(double dx, double dy, double turn, double leanX = 0, double leanY = 0) {
    PoseCorrection correction;
    correction.pivot = {1, 2};
    correction.mean << dx, dy, turn, leanX, leanY;
    return correction;
}

const ColumnPlace atPivot{{1, 2}, {1, 0}};

void expectAt(const TPoint2D& actual, double x, double y) {
    EXPECT_NEAR(actual.x, x, 1e-12);
    EXPECT_NEAR(actual.y, y, 1e-12);
}

}  // namespace

TEST(PoseCorrection, ofNothingLeavesEveryPlace) {
    expectAt(by(0, 0, 0).apply(atPivot, {{3, 0}, 1}), 4, 2);
}

TEST(PoseCorrection, shiftMovesAndTurnGoesRoundThePivot) {
    expectAt(by(0.1, -0.2, 0).apply(atPivot, {{3, 0}, 1}), 4.1, 1.8);
    expectAt(by(0, 0, quarter).apply(atPivot, {{3, 0}, 1}), 1, 5);
    expectAt(by(0.1, 0, quarter).apply({{2, 2}, {1, 0}}, {{3, 0}, 0}), 1.1, 6);
}

// Rolling to the left lifts the left side: what is seen above the sensor moves to the right.
TEST(PoseCorrection, leanMovesWhatIsHigh) {
    expectAt(by(0, 0, 0, 0.01).apply(atPivot, {{3, 0}, 2}), 4, 2 - 0.02);
    expectAt(by(0, 0, 0, 0, 0.01).apply(atPivot, {{3, 0}, 2}), 4 + 0.02, 2);
    expectAt(by(0, 0, 0, 0.01, 0.02).apply(atPivot, {{3, 0}, 0}), 4, 2);
}

TEST(PoseCorrection, leanIsThatOfTheVehicleNotOfTheMap) {
    const ColumnPlace headingLeft{{1, 2}, {0, 1}};
    expectAt(by(0, 0, 0, 0.01).apply(headingLeft, {{3, 0}, 2}), 4 + 0.02, 2);
}

TEST(PoseCorrection, leanAgreesWithTurningTheSensorInSpace) {
    const double roll = 0.004, pitch = -0.003;  // [rad] second order: 0.5 * 0.005^2 * 3 m = 4e-5 m
    const mrpt::poses::CPose3D leaning(0, 0, 0, 0, pitch, roll);
    const mrpt::math::TPoint3D local(2.5, -1.5, 1.2);
    mrpt::math::TPoint3D truly;
    leaning.composePoint(local, truly);
    const TPoint2D corrected =
        by(0, 0, 0, roll, pitch).apply(atPivot, {{local.x, local.y}, local.z});
    EXPECT_NEAR(corrected.x - 1, truly.x, 1e-4);
    EXPECT_NEAR(corrected.y - 2, truly.y, 1e-4);
}

TEST(PoseCorrection, gradientIsThatOfFiniteDifferences) {
    PoseCorrection correction = by(0.2, -0.1, 0.3, 0.02, -0.01);
    const ColumnPlace column{{1.5, 1.8}, {std::cos(0.7), std::sin(0.7)}};
    const SeenPoint point{{4, -2}, 1.3};
    const TPoint2D normal{0.6, 0.8};
    const auto across = [&] {
        const TPoint2D place = correction.apply(column, point);
        return normal.x * place.x + normal.y * place.y;
    };
    const Vector5 gradient = correction.gradient(column, point, normal);
    for (int i = 0; i < 5; ++i) {
        constexpr double step = 1e-6;
        const double mean = correction.mean[i];
        correction.mean[i] = mean + step;
        const double more = across();
        correction.mean[i] = mean - step;
        const double less = across();
        correction.mean[i] = mean;
        EXPECT_NEAR(gradient[i], (more - less) / (2 * step), 1e-6) << "parameter " << i;
    }
}

TEST(PlaceOf, columnTellsSensorAndHeadingOfTheVehicle) {
    ScanColumn column;
    const mrpt::poses::CPose3D vehicle(3, 4, 0, 0.5, 0, 0), mounting(0.2, 0, 1, 1.1, 0.3, quarter);
    column.sensorInVehicle = mounting.asTPose();
    column.sensor = SensorPose{vehicle + mounting, Eigen::Matrix3d::Zero()};
    const ColumnPlace place = placeOf(column);
    EXPECT_NEAR(place.position.x, 3 + 0.2 * std::cos(0.5), 1e-12);
    EXPECT_NEAR(place.position.y, 4 + 0.2 * std::sin(0.5), 1e-12);
    EXPECT_NEAR(place.vehicleAlong.x, std::cos(0.5), 1e-12);
    EXPECT_NEAR(place.vehicleAlong.y, std::sin(0.5), 1e-12);
}

}  // namespace offmap::core
