// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace offmap::core {

/// Where the sensor stood in the map while one column was taken, and how well that is known.
struct SensorPose {
    mrpt::poses::CPose3D sensorInMap;
    /// Covariance of the sensor's x, y [m] and of the robot's heading [rad] in the map plane.
    Eigen::Matrix3d groundCovariance = Eigen::Matrix3d::Zero();
};

/// Why a column has no pose that could be trusted. The points of such a column are kept.
enum class PoseFault : uint8_t {
    NoPose,        ///< no pose source, or none that covers this time
    TooOld,        ///< the nearest pose is too far away in time
    NotFinite,     ///< NaN or infinity in mean or covariance
    NotPsd,        ///< the covariance is not positive semidefinite
    TooUncertain,  ///< the position ellipse is so large that any segment would match
    OffMap,        ///< no wall within range of the sensor
    DoesNotFit,    ///< what the scan shows fits no place that the pose allows
};

/// Stable snake_case name, as in reports: "no_pose", "pose_too_old", ...
std::string_view toString(PoseFault fault);

/// Composes a vehicle pose with the mounting of the sensor. The yaw variance reaches the sensor's
/// position through its lever arm. Worked out in the map plane: composing Euler-angle PDFs through
/// a mount that is pitched by nearly 90 degrees inflates the yaw variance many times over.
SensorPose composeOnGround(const mrpt::poses::CPose3D& vehicleInMap,
                           const Eigen::Matrix3d& vehicleGroundCovariance,
                           const mrpt::poses::CPose3D& sensorInVehicle);

/// The x, y, yaw block of a pose covariance (order x y z yaw pitch roll) [m^2, m rad, rad^2].
Eigen::Matrix3d groundBlock(const mrpt::math::CMatrixDouble66& covariance);

/// True if symmetric, finite and without an eigenvalue below zero (to rounding).
bool isPositiveSemidefinite(const Eigen::Ref<const Eigen::MatrixXd>& covariance);

/// Why an estimate cannot be used, if so: NotFinite or NotPsd.
std::optional<PoseFault> faultOf(const mrpt::poses::CPose3DPDFGaussian& estimate);

}  // namespace offmap::core
