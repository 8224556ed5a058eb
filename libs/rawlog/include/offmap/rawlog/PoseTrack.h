// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/GroundCovariance.h>
#include <offmap/rawlog/PoseSource.h>

#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <optional>
#include <vector>

namespace offmap::rawlog {

/// One pose estimate of a log, compact: hours of them are held in memory.
struct StampedPose {
    mrpt::Clock::time_point time;
    mrpt::math::TPose3D vehicleInMap;
    GroundTriangle groundCovariance{};
    std::optional<core::PoseFault> fault;  ///< NotFinite or NotPsd: not to be used
};

/// MRPT documents `pose` as the pose of the robot, so `sensorPose` is not applied to it.
StampedPose stampedPose(const mrpt::obs::CObservationRobotPose& observation);

/// Poses from localisation. A time has a pose if the nearest one is at most `maxAge` away, or if it
/// lies between two that agree within 3 sigma, whatever the gap: the robot stood. Between two poses
/// mean and covariance are interpolated; beyond the ends nothing is extrapolated. A look-up that
/// would use a faulty pose answers with its fault.
class PoseTrack : public PoseSource {
 public:
    /// \param poses in any order \param maxAge [s]
    /// \throw std::invalid_argument if maxAge is negative or not finite.
    explicit PoseTrack(std::vector<StampedPose> poses, double maxAge = 0.5);

    PoseLookup at(mrpt::Clock::time_point time) const override;
    SettledPoses settled() const override { return allSettled; }

    size_t size() const { return poses_.size(); }
    /// Of the first and the last pose; both none if there are no poses.
    std::optional<mrpt::Clock::time_point> begin() const;
    std::optional<mrpt::Clock::time_point> end() const;

 private:
    PoseLookup atSingle(const StampedPose& pose, mrpt::Clock::time_point time) const;
    PoseLookup between(const StampedPose& before, const StampedPose& after,
                       mrpt::Clock::time_point time) const;

    std::vector<StampedPose> poses_;  ///< by time
    double maxAge_;                   ///< [s]
};

}  // namespace offmap::rawlog
