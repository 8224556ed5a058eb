// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionResult.h>

#include <array>
#include <string_view>

namespace offmap::view {

/// Why returns are kept, in the order in which they are told of.
inline constexpr std::array keepReasons{
    core::KeepReason::InFrontOfWall, core::KeepReason::BehindWall, core::KeepReason::NoWallOnRay,
    core::KeepReason::AmbiguousCorner, core::KeepReason::NoPose};

/// "in front of a wall"; empty for KeepReason::None.
std::string_view inWords(core::KeepReason reason);

}  // namespace offmap::view
