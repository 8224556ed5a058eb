// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace offmap::evaluation {

// What writer and reader of a truth file agree on.

inline constexpr std::string_view truthHeader =
    "scan,time_s,sensor,x_m,y_m,z_m,mapped,kind,stand_off_m,on_vertical_segment";

/// By SurfaceKind.
inline constexpr std::array<std::string_view, 4> kindNames{"wall", "floor", "ceiling", "object"};

/// 1970-01-01 in ticks of mrpt::Clock, which counts from 1601-01-01.
inline constexpr int64_t epochTicks = 116'444'736'000'000'000;
inline constexpr int64_t ticksPerSecond = 10'000'000;
inline constexpr int tickDigits = 7;  ///< behind the decimal point of a second

}  // namespace offmap::evaluation
