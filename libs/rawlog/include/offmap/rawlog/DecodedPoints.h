// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/math/TPoint3D.h>

#include <vector>

namespace offmap::rawlog {

/// The returns of an observation as points in its sensor's frame [m]: those that
/// ScanClass::asPointCloud() gives for it, as far as they are finite and not zero. The same bits
/// from the observation, from a reduced one as far as they are still in it, and from the point
/// cloud that either may have become.
std::vector<mrpt::math::TPoint3Df> decodedPoints(const mrpt::obs::CObservation& obs,
                                                 const ScanClass& scanClass,
                                                 const SensorConfig& config);

}  // namespace offmap::rawlog
