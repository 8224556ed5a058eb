// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/FixedPose.h>

#include <cmath>
#include <stdexcept>

namespace offmap::rawlog {

FixedPose::FixedPose(const mrpt::math::TPose2D& vehicleInMap, double sigmaPosition,
                     double sigmaHeading) {
    if (!std::isfinite(vehicleInMap.x) || !std::isfinite(vehicleInMap.y) ||
        !std::isfinite(vehicleInMap.phi)) {
        throw std::invalid_argument("fixed pose: x, y and yaw must be finite numbers");
    }
    const auto isSigma = [](double s) { return std::isfinite(s) && s >= 0; };
    if (!isSigma(sigmaPosition) || !isSigma(sigmaHeading)) {
        throw std::invalid_argument("fixed pose: its sigmas must be finite and not negative");
    }
    pose_.vehicleInMap.emplace(vehicleInMap.x, vehicleInMap.y, 0.0, vehicleInMap.phi, 0.0, 0.0);
    const double variance = sigmaPosition * sigmaPosition;
    pose_.groundCovariance.diagonal() << variance, variance, sigmaHeading * sigmaHeading;
}

FixedPose::FixedPose(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap) {
    if (const auto fault = core::faultOf(vehicleInMap)) {
        pose_.fault = *fault;
        return;
    }
    pose_.vehicleInMap = vehicleInMap.mean;
    pose_.groundCovariance = core::groundBlock(vehicleInMap.cov);
}

PoseLookup FixedPose::at(mrpt::Clock::time_point) const { return pose_; }

}  // namespace offmap::rawlog
