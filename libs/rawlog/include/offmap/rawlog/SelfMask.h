// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SensorConfig.h>

namespace offmap::rawlog {

/// Takes out of a turn's scan what the sensor sees of its own robot: returns nearer to it than
/// SensorConfig::minRange, and those in SensorConfig::robotBox, its faces included. So they are on
/// no segment and never removed. Counts them in ReturnCounts::self.
/// \param firstColumn those before are left as they are
void maskSelfReturns(TurnScan& turn, const SensorConfig& config, size_t firstColumn = 0);

}  // namespace offmap::rawlog
