// SPDX-License-Identifier: BSD-3-Clause
#include "SecondsBetween.h"
#include "WrappedAngle.h"

#include <offmap/rawlog/PoseTrack.h>

#include <Eigen/Cholesky>
#include <mrpt/math/slerp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace offmap::rawlog {
namespace {

using mrpt::math::TPose3D;
using TimePoint = mrpt::Clock::time_point;

bool isUpright(const TPose3D& pose) { return pose.pitch == 0 && pose.roll == 0; }

TPose3D interpolated(const TPose3D& from, const TPose3D& to, double share) {
    TPose3D pose;
    if (isUpright(from) && isUpright(to)) {  // the same rotation as below, found more quickly
        pose.yaw = wrapped(from.yaw + share * wrapped(to.yaw - from.yaw));
    } else {
        mrpt::math::slerp_ypr(from, to, share, pose);
    }
    pose.x = std::lerp(from.x, to.x, share);
    pose.y = std::lerp(from.y, to.y, share);
    pose.z = std::lerp(from.z, to.z, share);
    return pose;
}

// Mahalanobis distance of x, y, yaw under the sum of the covariances, within 3.
bool agree(const StampedPose& a, const StampedPose& b) {
    constexpr double floorPosition = 1e-3;                // [m]
    constexpr double floorHeading = 0.05 * M_PI / 180.0;  // [rad]
    const Eigen::Vector3d floorVariance(floorPosition * floorPosition,
                                        floorPosition * floorPosition, floorHeading * floorHeading);
    const Eigen::Vector3d difference(b.vehicleInMap.x - a.vehicleInMap.x,
                                     b.vehicleInMap.y - a.vehicleInMap.y,
                                     wrapped(b.vehicleInMap.yaw - a.vehicleInMap.yaw));
    Eigen::Matrix3d sum = matrixOf(a.groundCovariance) + matrixOf(b.groundCovariance);
    sum.diagonal() += floorVariance;
    return difference.dot(sum.ldlt().solve(difference)) <= 9.0;
}

/// Upright, with one sine and cosine in place of three.
void setPose(std::optional<mrpt::poses::CPose3D>& pose, const TPose3D& mean) {
    if (!isUpright(mean)) {
        pose.emplace(mean);
        return;
    }
    const double c = std::cos(mean.yaw), s = std::sin(mean.yaw);
    pose.emplace(mrpt::poses::UNINITIALIZED_POSE)
        .setFrom12Vector(std::array{c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0, mean.x, mean.y, mean.z});
}

PoseLookup lookup(const TPose3D& mean, const GroundTriangle& covariance) {
    PoseLookup found;
    setPose(found.vehicleInMap, mean);
    found.groundCovariance = matrixOf(covariance);
    return found;
}

PoseLookup none(core::PoseFault fault) { return {std::nullopt, Eigen::Matrix3d::Zero(), fault}; }

}  // namespace

StampedPose stampedPose(const mrpt::obs::CObservationRobotPose& observation) {
    StampedPose pose{observation.timestamp,
                     observation.pose.mean.asTPose(),
                     {},
                     core::faultOf(observation.pose)};
    pose.groundCovariance = triangleOf(core::groundBlock(observation.pose.cov));
    return pose;
}

PoseTrack::PoseTrack(std::vector<StampedPose> poses, double maxAge)
    : poses_(std::move(poses)), maxAge_(maxAge) {
    if (!std::isfinite(maxAge) || maxAge < 0) {
        throw std::invalid_argument("the greatest age of a pose must be finite and not negative");
    }
    std::ranges::stable_sort(poses_, {}, &StampedPose::time);
}

std::optional<TimePoint> PoseTrack::begin() const {
    return poses_.empty() ? std::nullopt : std::optional(poses_.front().time);
}

std::optional<TimePoint> PoseTrack::end() const {
    return poses_.empty() ? std::nullopt : std::optional(poses_.back().time);
}

PoseLookup PoseTrack::at(TimePoint time) const {
    if (poses_.empty()) return none(core::PoseFault::NoPose);
    const auto after = std::ranges::upper_bound(poses_, time, {}, &StampedPose::time);
    if (after == poses_.begin()) return atSingle(*after, time);
    const StampedPose& before = *std::prev(after);
    if (after == poses_.end() || before.time == time) return atSingle(before, time);
    return between(before, *after, time);
}

PoseLookup PoseTrack::atSingle(const StampedPose& pose, TimePoint time) const {
    const double age = secondsBetween(std::min(pose.time, time), std::max(pose.time, time));
    if (age > maxAge_) return none(core::PoseFault::TooOld);
    if (pose.fault) return none(*pose.fault);
    return lookup(pose.vehicleInMap, pose.groundCovariance);
}

PoseLookup PoseTrack::between(const StampedPose& before, const StampedPose& after,
                              TimePoint time) const {
    if (before.fault) return none(*before.fault);
    if (after.fault) return none(*after.fault);
    const double sinceBefore = secondsBetween(before.time, time);
    const double untilAfter = secondsBetween(time, after.time);
    if (std::min(sinceBefore, untilAfter) > maxAge_ && !agree(before, after)) {
        return none(core::PoseFault::TooOld);
    }
    const double share = sinceBefore / (sinceBefore + untilAfter);
    GroundTriangle covariance;
    for (size_t i = 0; i < covariance.size(); ++i) {
        covariance[i] =
            (1 - share) * before.groundCovariance[i] + share * after.groundCovariance[i];
    }
    return lookup(interpolated(before.vehicleInMap, after.vehicleInMap, share), covariance);
}

}  // namespace offmap::rawlog
