// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Wording.h>

namespace offmap::view {

std::string_view inWords(core::KeepReason reason) {
    using core::KeepReason;
    switch (reason) {
        case KeepReason::None:
            break;
        case KeepReason::InFrontOfWall:
            return "in front of a wall";
        case KeepReason::BehindWall:
            return "behind a wall";
        case KeepReason::NoWallOnRay:
            return "no wall on the ray";
        case KeepReason::AmbiguousCorner:
            return "ambiguous corner";
        case KeepReason::NoPose:
            return "no pose";
    }
    return "";
}

}  // namespace offmap::view
