// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseSource.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <mutex>

namespace offmap::live {

/// How far a vehicle may have moved since its pose was last known.
struct MotionNoise {
    double speed = 0.5;          ///< [m/s] standard deviation of its speed, along x and along y
    double turnRate = 0.35;      ///< [rad/s] standard deviation of its turning
    double sigmaPosition = 0.1;  ///< [m] of the initial pose
    double sigmaHeading = 0.05;  ///< [rad] of the initial pose
};

/// A vehicle without localisation: the pose that the last scan was found to be taken from, less
/// certain the longer ago that is, is where the next one is looked for. Any thread may use it.
class TrackedPoses : public rawlog::PoseSource {
 public:
    /// \param initial vehicleInMap [m], [rad]
    /// \throw std::invalid_argument if something is not finite or a sigma is negative
    TrackedPoses(const mrpt::math::TPose2D& initial, const MotionNoise& noise);

    /// At the times before the last correction as certain as then.
    rawlog::PoseLookup at(mrpt::Clock::time_point time) const override;

    /// All, until the next correction.
    rawlog::SettledPoses settled() const override;

    /// A pose that a scan of that time was found to be taken from. Older ones change nothing.
    void correct(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap, mrpt::Clock::time_point time);

    uint64_t corrections() const;

 private:
    const MotionNoise noise_;
    mutable std::mutex mutex_;
    rawlog::PoseLookup last_;
    std::optional<mrpt::Clock::time_point> time_;  // of the last correction
    uint64_t corrections_ = 0;
};

}  // namespace offmap::live
