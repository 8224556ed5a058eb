// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SensorPose.h>

#include <Eigen/Eigenvalues>
#include <mrpt/math/TPose3D.h>

#include <cmath>

namespace offmap::core {

std::string_view toString(PoseFault fault) {
    switch (fault) {
        case PoseFault::NoPose:
            return "no_pose";
        case PoseFault::TooOld:
            return "pose_too_old";
        case PoseFault::NotFinite:
            return "pose_not_finite";
        case PoseFault::NotPsd:
            return "covariance_not_psd";
        case PoseFault::TooUncertain:
            return "pose_too_uncertain";
        case PoseFault::OffMap:
            return "no_wall_in_range";
        case PoseFault::DoesNotFit:
            return "pose_does_not_fit";
    }
    return "unknown";
}

SensorPose composeOnGround(const mrpt::poses::CPose3D& vehicleInMap,
                           const Eigen::Matrix3d& vehicleGroundCovariance,
                           const mrpt::poses::CPose3D& sensorInVehicle) {
    SensorPose sensor;
    sensor.sensorInMap.composeFrom(vehicleInMap, sensorInVehicle);
    // A turn of the vehicle by dyaw moves the sensor by dyaw times the lever, turned left by 90
    // degrees: J C J' with a J that is the identity but for two elements.
    const double dx = -(sensor.sensorInMap.y() - vehicleInMap.y());
    const double dy = sensor.sensorInMap.x() - vehicleInMap.x();
    Eigen::Matrix3d& covariance = sensor.groundCovariance = vehicleGroundCovariance;
    covariance.row(0) += dx * covariance.row(2);
    covariance.row(1) += dy * covariance.row(2);
    covariance.col(0) += dx * covariance.col(2);
    covariance.col(1) += dy * covariance.col(2);
    return sensor;
}

Eigen::Matrix3d groundBlock(const mrpt::math::CMatrixDouble66& covariance) {
    constexpr int order[3] = {0, 1, 3};  // x, y, yaw of x y z yaw pitch roll
    Eigen::Matrix3d ground;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) ground(r, c) = covariance(order[r], order[c]);
    }
    return ground;
}

bool isPositiveSemidefinite(const Eigen::Ref<const Eigen::MatrixXd>& covariance) {
    if (covariance.rows() != covariance.cols() || !covariance.allFinite()) return false;
    const double scale = covariance.cwiseAbs().maxCoeff();
    // What double arithmetic loses in composing poses, and single precision in other programs'
    // logs.
    const double tolerance = 1e-6 * scale;
    if ((covariance - covariance.transpose()).cwiseAbs().maxCoeff() > tolerance) return false;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance, Eigen::EigenvaluesOnly);
    return solver.info() == Eigen::Success && solver.eigenvalues()(0) >= -tolerance;
}

std::optional<PoseFault> faultOf(const mrpt::poses::CPose3DPDFGaussian& estimate) {
    const mrpt::math::TPose3D mean = estimate.mean.asTPose();
    for (size_t i = 0; i < mrpt::math::TPose3D::static_size; ++i) {
        if (!std::isfinite(mean[i])) return PoseFault::NotFinite;
    }
    if (!estimate.cov.asEigen().allFinite()) return PoseFault::NotFinite;
    if (!isPositiveSemidefinite(estimate.cov.asEigen())) return PoseFault::NotPsd;
    return std::nullopt;
}

}  // namespace offmap::core
