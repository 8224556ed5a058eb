// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/bits_math.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

namespace offmap::test {

using Fan = mrpt::obs::CObservation2DRangeScan;

/// The mounting of a turned scanner: its x axis looks along `yaw` and up by `elevation`, the fan
/// stands upright; with `beamsUp` it turns from x upwards, else downwards. Angles in degrees.
inline mrpt::poses::CPose3D fanPose(double yaw, double elevation = 0, bool beamsUp = true,
                                    const mrpt::math::TPoint3D& position = {0, 0, 1}) {
    return {position.x,
            position.y,
            position.z,
            mrpt::DEG2RAD(yaw),
            mrpt::DEG2RAD(-elevation),
            mrpt::DEG2RAD(beamsUp ? 90.0 : -90.0)};
}

struct FanOptions {
    double aperture = 170;  ///< [deg]
    size_t rays = 171;
    bool rightToLeft = true;
    std::chrono::milliseconds time{0};
};

inline std::shared_ptr<Fan> fanWithoutReturns(const mrpt::poses::CPose3D& pose,
                                              const FanOptions& options = {}) {
    auto fan = std::make_shared<Fan>();
    fan->sensorLabel = "SWEEP";
    fan->timestamp = mrpt::Clock::fromDouble(1.7e9) + options.time;
    fan->sensorPose = pose;
    fan->aperture = static_cast<float>(mrpt::DEG2RAD(options.aperture));
    fan->rightToLeft = options.rightToLeft;
    fan->resizeScanAndAssign(options.rays, 0.0F, false);
    return fan;
}

/// Range [m] from a point in the direction of a unit vector, vehicle frame; 0 for none.
using World = std::function<double(const mrpt::math::TPoint3D&, const mrpt::math::TPoint3D&)>;

/// Unit vector of ray i in the sensor's frame, by MRPT's own account.
inline mrpt::math::TPoint3D rayDirection(const Fan& fan, size_t i) {
    const double angle = fan.getScanAngle(i);
    return {std::cos(angle), std::sin(angle), 0};
}

inline std::shared_ptr<Fan> fanIn(const World& world, const mrpt::poses::CPose3D& pose,
                                  const FanOptions& options = {}) {
    auto fan = fanWithoutReturns(pose, options);
    for (size_t i = 0; i < options.rays; ++i) {
        const mrpt::math::TPoint3D direction = pose.rotateVector(rayDirection(*fan, i));
        const double range = world(pose.translation(), direction);
        fan->setScanRange(i, static_cast<float>(range));
        fan->setScanRangeValidity(i, range > 0);
    }
    return fan;
}

/// A wall across the x axis.
inline World wallAhead(double x) {
    return [x](const auto& from, const auto& direction) {
        return direction.x > 1e-3 ? (x - from.x) / direction.x : 0.0;
    };
}

/// A room of 10 x 10 x 6 m around the origin, from z = -3 to 3.
inline World room() {
    return [](const auto& from, const auto& direction) {
        const double half[3] = {5, 5, 3};
        double nearest = 1e9;
        for (int a = 0; a < 3; ++a) {
            if (std::abs(direction[a]) < 1e-9) continue;
            const double face = direction[a] > 0 ? half[a] : -half[a];
            nearest = std::min(nearest, (face - from[a]) / direction[a]);
        }
        return nearest;
    };
}

}  // namespace offmap::test
