// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseSource.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

namespace offmap::rawlog {

/// A vehicle that stands still on the ground.
class FixedPose : public PoseSource {
 public:
    /// \param vehicleInMap [m], [rad]
    /// \param sigmaPosition standard deviation of x and of y [m]
    /// \param sigmaHeading standard deviation of the heading [rad]
    /// \throw std::invalid_argument if something is not finite or a sigma is negative.
    FixedPose(const mrpt::math::TPose2D& vehicleInMap, double sigmaPosition, double sigmaHeading);

    /// An estimate that is not finite, or whose covariance is none, is no pose: at() answers with
    /// its fault. One in the plane becomes CPose3DPDFGaussian(CPosePDFGaussian(...)).
    explicit FixedPose(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap);

    PoseLookup at(mrpt::Clock::time_point time) const override;
    SettledPoses settled() const override { return allSettled; }

 private:
    PoseLookup pose_;
};

}  // namespace offmap::rawlog
