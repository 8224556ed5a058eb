// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>

#include <Eigen/Geometry>
#include <mrpt/math/wrap2pi.h>

namespace offmap::core {

using mrpt::poses::CPose3D;
using Vector6 = Eigen::Matrix<double, 6, 1>;

namespace {

/// Leans about the vehicle's axes first, then turns the heading.
Eigen::Matrix3d rotationBy(const Vector5& mean, const mrpt::math::TPoint2D& along) {
    const Eigen::Vector3d lean(mean[3] * along.x - mean[4] * along.y,
                               mean[3] * along.y + mean[4] * along.x, 0);
    const Eigen::AngleAxisd turn(mean[2], Eigen::Vector3d::UnitZ());
    const double angle = lean.norm();
    if (!(angle > 0)) return turn.toRotationMatrix();
    return (turn * Eigen::AngleAxisd(angle, lean / angle)).toRotationMatrix();
}

CPose3D vehicleBy(const PoseCorrection& correction, const ScanColumn& column) {
    const CPose3D toVehicle = -CPose3D(column.sensorInVehicle);
    CPose3D vehicle = correctedSensor(correction, column) + toVehicle;
    vehicle.z((column.sensor->sensorInMap + toVehicle).z());
    return vehicle;
}

/// x, y, z, yaw, pitch, roll, as MRPT orders them.
Vector6 valuesOf(const CPose3D& pose) {
    Vector6 out;
    out << pose.x(), pose.y(), pose.z(), pose.yaw(), pose.pitch(), pose.roll();
    return out;
}

/// Derivative of the vehicle's pose by the correction.
Eigen::Matrix<double, 6, 5> jacobianOf(PoseCorrection correction, const ScanColumn& column) {
    // [m], [rad] Central differences: the error goes with its square, rounding with its inverse.
    constexpr double step = 1e-5;
    Eigen::Matrix<double, 6, 5> jacobian;
    for (int i = 0; i < 5; ++i) {
        const double mean = correction.mean[i];
        correction.mean[i] = mean + step;
        const Vector6 more = valuesOf(vehicleBy(correction, column));
        correction.mean[i] = mean - step;
        Vector6 difference = more - valuesOf(vehicleBy(correction, column));
        correction.mean[i] = mean;
        for (int angle = 3; angle < 6; ++angle) mrpt::math::wrapToPiInPlace(difference[angle]);
        jacobian.col(i) = difference / (2 * step);
    }
    return jacobian;
}

}  // namespace

CPose3D correctedSensor(const PoseCorrection& correction, const ScanColumn& column) {
    const CPose3D& sensor = column.sensor->sensorInMap;
    const ColumnPlace place = placeOf(column);
    const mrpt::math::TPoint2D position = correction.apply(place, {{0, 0}, 0});
    const Eigen::Matrix3d rotation =
        rotationBy(correction.mean, place.vehicleAlong) * sensor.getRotationMatrix().asEigen();
    return CPose3D(mrpt::math::CMatrixDouble33(rotation),
                   mrpt::math::CVectorFixedDouble<3>({position.x, position.y, sensor.z()}));
}

mrpt::poses::CPose3DPDFGaussian correctedVehicle(const PoseCorrection& correction,
                                                 const ScanColumn& column) {
    const Eigen::Matrix<double, 6, 5> jacobian = jacobianOf(correction, column);
    const Eigen::Matrix<double, 6, 6> covariance =
        jacobian * correction.covariance * jacobian.transpose();
    // Rounding leaves it a little lopsided.
    return {vehicleBy(correction, column),
            mrpt::math::CMatrixDouble66((0.5 * (covariance + covariance.transpose())).eval())};
}

}  // namespace offmap::core
