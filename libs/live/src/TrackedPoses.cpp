// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SensorPose.h>
#include <offmap/live/TrackedPoses.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace offmap::live {

namespace {

double squared(double x) { return x * x; }

}  // namespace

TrackedPoses::TrackedPoses(const mrpt::math::TPose2D& initial, const MotionNoise& noise)
    : noise_(noise) {
    for (const double value : {initial.x, initial.y, initial.phi}) {
        if (!std::isfinite(value))
            throw std::invalid_argument("TrackedPoses: the initial pose is not finite");
    }
    for (const double sigma :
         {noise.speed, noise.turnRate, noise.sigmaPosition, noise.sigmaHeading}) {
        if (!(sigma >= 0) || std::isinf(sigma))
            throw std::invalid_argument("TrackedPoses: a standard deviation below 0");
    }
    last_.vehicleInMap.emplace(initial.x, initial.y, 0, initial.phi, 0, 0);
    last_.groundCovariance.diagonal() << squared(noise.sigmaPosition), squared(noise.sigmaPosition),
        squared(noise.sigmaHeading);
}

rawlog::PoseLookup TrackedPoses::at(mrpt::Clock::time_point time) const {
    const std::lock_guard lock(mutex_);
    rawlog::PoseLookup pose = last_;
    if (time_) {
        // A vehicle that keeps its unknown speed: the deviation grows with the time, not its root.
        const double passed = std::max(0.0, std::chrono::duration<double>(time - *time_).count());
        const double moved = squared(noise_.speed * passed);
        pose.groundCovariance.diagonal() +=
            Eigen::Vector3d(moved, moved, squared(noise_.turnRate * passed));
    }
    return pose;
}

rawlog::SettledPoses TrackedPoses::settled() const {
    return {mrpt::Clock::time_point::max(), corrections()};
}

void TrackedPoses::correct(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap,
                           mrpt::Clock::time_point time) {
    if (core::faultOf(vehicleInMap)) return;
    const std::lock_guard lock(mutex_);
    if (time_ && time < *time_) return;
    last_.vehicleInMap = vehicleInMap.mean;
    last_.groundCovariance = core::groundBlock(vehicleInMap.cov);
    time_ = time;
    ++corrections_;
}

uint64_t TrackedPoses::corrections() const {
    const std::lock_guard lock(mutex_);
    return corrections_;
}

}  // namespace offmap::live
