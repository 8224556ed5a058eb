// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SensorConfig.h>

#include <span>

namespace offmap::rawlog {

/// [m] Standard deviation of the range of a return that bright.
/// \param table SensorConfig::rangeSigmaByIntensity, not empty
double rangeSigmaAt(std::span<const double> table, double intensity);

/// Gives the points of a turn's scan that have none the sigmas that its sensor's table tells, if
/// there is a table and any observation tells intensities. To be called once no more of them are
/// taken out.
/// \param unknown [m] of returns whose intensity is not told
void findRangeSigmas(TurnScan& out, const Turn& turn, const ScanClass& scanClass,
                     const SensorConfig& config, double unknown);

}  // namespace offmap::rawlog
