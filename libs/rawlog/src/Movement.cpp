// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Movement.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

namespace {

double distanceBetween(const mrpt::math::TPose3D& a, const mrpt::math::TPose3D& b) {
    return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

double secondsBetween(mrpt::Clock::time_point earlier, mrpt::Clock::time_point later) {
    return mrpt::Clock::toDouble(later) - mrpt::Clock::toDouble(earlier);
}

}  // namespace

void Movement::add(mrpt::Clock::time_point time, const mrpt::math::TPose3D& vehicleInMap,
                   double sigma) {
    const Pose pose{time, vehicleInMap};
    if (!first_) {
        first_ = latest_ = corner_ = pose;
        return;
    }
    seconds_ = std::max(seconds_, secondsBetween(first_->time, time));
    const double step = distanceBetween(corner_->vehicleInMap, vehicleInMap);
    if (step > std::max(0.1, 3 * sigma)) {
        distance_ += step;
        corner_ = pose;
    }
    const double since = secondsBetween(latest_->time, time);
    if (since < 0.5) return;
    const double turned = mrpt::math::wrapToPi(vehicleInMap.yaw - latest_->vehicleInMap.yaw);
    maxSpeed_ = std::max(maxSpeed_, distanceBetween(latest_->vehicleInMap, vehicleInMap) / since);
    maxTurnRate_ = std::max(maxTurnRate_, std::abs(turned) / since);
    latest_ = pose;
}

std::optional<double> Movement::meanSpeed() const {
    return seconds_ > 0 ? std::optional(distance_ / seconds_) : std::nullopt;
}

}  // namespace offmap::rawlog
