// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/MapMatching.h>
#include <offmap/rawlog/PoseCoverage.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

void PoseCoverage::add(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& sensorInVehicle) {
    ++observations_;
    const PoseLookup lookup = poses_.at(time);
    std::optional<core::PoseFault> fault;
    if (lookup.vehicleInMap) {
        const auto sensor =
            core::composeOnGround(*lookup.vehicleInMap, lookup.groundCovariance, sensorInVehicle);
        fault = core::faultOf(core::viewpointOf(sensor), config_);
    } else {
        fault = lookup.fault;
    }
    if (fault) {
        ++faults_[*fault];
    } else {
        ++covered_;
    }
}

void PoseCoverage::follow(mrpt::Clock::time_point time) {
    // Ten times a second is enough for the movement, whatever the sensors' rates.
    if (followed_ && mrpt::Clock::toDouble(time) - mrpt::Clock::toDouble(*followed_) < 0.1) return;
    followed_ = time;
    const PoseLookup lookup = poses_.at(time);
    if (!lookup.vehicleInMap) return;
    const auto& covariance = lookup.groundCovariance;
    const double variance = std::max({0.0, covariance(0, 0), covariance(1, 1)});
    const double sigma = errors_ == Errors::Common ? 0 : std::sqrt(variance);
    movement_.add(time, lookup.vehicleInMap->asTPose(), sigma);
}

double PoseCoverage::share() const {
    if (observations_ == 0) return 0;
    return static_cast<double>(covered_) / static_cast<double>(observations_);
}

}  // namespace offmap::rawlog
