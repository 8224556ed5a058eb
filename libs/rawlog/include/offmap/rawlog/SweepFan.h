// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// Whether the plane of the beams contains the vertical within 15 degrees.
bool isVerticalFan(const mrpt::obs::CObservation2DRangeScan& scan);

/// The sensor's axis that tells which way along its horizontal line a fan looks: x, or y if x is
/// steeper than 75 degrees. To be chosen once a turn, so that all of its fans look the same way.
enum class FanAxis : uint8_t { X, Y };
FanAxis chooseFanAxis(const mrpt::obs::CObservation2DRangeScan& scan);

/// Unit vector in the vehicle's axes: the horizontal line of a vertical fan.
mrpt::math::TPoint2D fanDirection(const mrpt::obs::CObservation2DRangeScan& scan, FanAxis axis);

/// [rad] CCW from the vehicle's x axis.
double fanAzimuth(const mrpt::obs::CObservation2DRangeScan& scan, FanAxis axis);

/// Direction of beam i in the plane of the fan, from the x axis to the y axis [rad].
double beamAngle(const mrpt::obs::CObservation2DRangeScan& scan, size_t i);

/// Unit vectors of the beams in the frame of the sensor, remembered from scan to scan.
class BeamDirections {
 public:
    const std::vector<mrpt::math::TPoint2D>& of(const mrpt::obs::CObservation2DRangeScan& scan);

 private:
    std::vector<mrpt::math::TPoint2D> directions_;
    float aperture_ = 0;
    bool rightToLeft_ = true;
};

}  // namespace offmap::rawlog
