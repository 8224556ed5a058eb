// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <string>

namespace offmap::app {

/// ISO 8601, "2026-07-30T12:34:56.789Z"; "no time" for what lies outside the years 1 to 9999.
std::string utcText(mrpt::Clock::time_point time);

}  // namespace offmap::app
