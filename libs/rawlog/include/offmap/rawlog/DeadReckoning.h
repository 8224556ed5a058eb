// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/MotionStep.h>
#include <offmap/rawlog/PoseTrack.h>

#include <Eigen/Core>
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <vector>

namespace offmap::rawlog {

/// Adds up movements from a place that is known. The mean is composed in space, the covariance in
/// the map plane: a movement's own, turned into the map, and the heading's times the way, turned by
/// 90 degrees. Composed as Euler angles, the yaw variance would explode at a pitch near 90 degrees.
class DeadReckoning {
 public:
    /// \param initialInMap before the first movement [m], [rad]
    /// \param sigmaPosition standard deviation of its x and of its y [m]
    /// \param sigmaHeading standard deviation of its heading [rad]
    DeadReckoning(const mrpt::math::TPose2D& initialInMap, double sigmaPosition,
                  double sigmaHeading);

    /// After a faulty movement nobody knows where the vehicle is: all poses from there on are
    /// faulty. A step without a time moves the vehicle, but leaves no pose.
    void move(const MotionStep& step);

    const std::vector<StampedPose>& poses() const { return poses_; }
    std::vector<StampedPose> takePoses() { return std::move(poses_); }

 private:
    mrpt::math::TPose3D vehicleInMap_;
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
    std::optional<core::PoseFault> fault_;
    std::vector<StampedPose> poses_;
};

}  // namespace offmap::rawlog
