// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Direction.h>

#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/VelodyneCalibration.h>

#include <cstdint>

namespace offmap::rawlog {

/// \param direction clockwise, as the sensor counts its azimuth
inline mrpt::math::TPoint3Df pointOf(uint16_t distance, const Direction& direction,
                                     const mrpt::obs::VelodyneCalibration::PerLaserCalib& laser) {
    const double range =
        distance * static_cast<double>(mrpt::obs::CObservationVelodyneScan::DISTANCE_RESOLUTION) +
        laser.distanceCorrection;
    const double ground =
        range * laser.cosVertCorrection + laser.verticalOffsetCorrection * laser.sinVertCorrection;
    const double offset = laser.horizontalOffsetCorrection;
    const auto [c, s] = direction;
    return {static_cast<float>(ground * c + offset * s),
            static_cast<float>(offset * c - ground * s),
            static_cast<float>(range * laser.sinVertCorrection + laser.verticalOffsetCorrection)};
}

}  // namespace offmap::rawlog
