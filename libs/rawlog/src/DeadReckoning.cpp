// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/DeadReckoning.h>

#include <Eigen/Geometry>
#include <mrpt/poses/CPose3D.h>

#include <cmath>

namespace offmap::rawlog {

using mrpt::poses::CPose3D;

DeadReckoning::DeadReckoning(const mrpt::math::TPose2D& initialInMap, double sigmaPosition,
                             double sigmaHeading)
    : vehicleInMap_(initialInMap) {
    const double variance = sigmaPosition * sigmaPosition;
    covariance_.diagonal() << variance, variance, sigmaHeading * sigmaHeading;
}

void DeadReckoning::move(const MotionStep& step) {
    if (!fault_) fault_ = step.fault;
    if (!fault_) {
        Eigen::Matrix3d intoMap = Eigen::Matrix3d::Identity();
        intoMap.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(vehicleInMap_.yaw).toRotationMatrix();
        const core::SensorPose moved = core::composeOnGround(CPose3D(vehicleInMap_), covariance_,
                                                             CPose3D(step.vehicleInPrevious));
        // As angles, not as a matrix: rounding never adds up to a rotation that is none.
        vehicleInMap_ = moved.sensorInMap.asTPose();
        covariance_ = moved.groundCovariance +
                      intoMap * matrixOf(step.groundCovariance) * intoMap.transpose();
        const bool finite = std::isfinite(vehicleInMap_.x) && std::isfinite(vehicleInMap_.y) &&
                            std::isfinite(vehicleInMap_.z) && covariance_.allFinite();
        if (!finite) fault_ = core::PoseFault::NotFinite;
    }
    if (step.time) poses_.push_back({*step.time, vehicleInMap_, triangleOf(covariance_), fault_});
}

}  // namespace offmap::rawlog
