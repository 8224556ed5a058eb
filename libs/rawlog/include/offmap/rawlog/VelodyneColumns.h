// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/VelodynePackets.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// Returns that look into the same direction.
struct VelodyneColumn {
    double azimuth = 0;              ///< [rad] CCW from the sensor's x axis
    mrpt::Clock::time_point time{};  ///< of the firing that looks there
    uint32_t begin = 0, end = 0;     ///< half-open range into VelodyneColumns::returns
};

struct VelodyneColumns {
    std::vector<uint32_t> returns;  ///< indices into VelodyneReturns::points, column after column
    std::vector<VelodyneColumn> columns;
};

/// A column a firing, in the order of rotation; behind them, those of the second returns of dual
/// return mode, as far as there are any: in one column, they would zigzag between two surfaces.
/// A laser with an azimuth correction looks where the head was, or will be, some firings away: its
/// return goes to that column. A column of an HDL-64E, corrected by up to 9 degrees, thus gathers
/// returns of 5 ms, and some lasers alone look past the first and the last firing.
/// \param firstFiring without azimuth corrections: of those before, only the second returns
VelodyneColumns gatherColumns(const VelodyneReturns& returns, size_t firstFiring = 0);

/// The columns of first returns of firings [begin, end), of a sensor without azimuth corrections.
VelodyneColumns gatherFirstReturns(const VelodyneReturns& returns, size_t begin, size_t end);

}  // namespace offmap::rawlog
