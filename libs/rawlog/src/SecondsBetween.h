// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <cstdint>

namespace offmap::rawlog {

/// [s] Unsigned: stamps of a corrupt log may lie further apart than a signed difference can tell,
/// and mrpt::Clock::toDouble() overflows on them. \pre earlier <= later
inline double secondsBetween(mrpt::Clock::time_point earlier, mrpt::Clock::time_point later) {
    const auto ticks = static_cast<uint64_t>(later.time_since_epoch().count()) -
                       static_cast<uint64_t>(earlier.time_since_epoch().count());
    using Period = mrpt::Clock::period;
    return static_cast<double>(ticks) * Period::num / Period::den;
}

}  // namespace offmap::rawlog
