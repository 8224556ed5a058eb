// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ReductionResult.h>

namespace offmap::core {

std::string_view toString(Verdict verdict) {
    switch (verdict) {
        case Verdict::MappedByRay:
            return "mapped_by_ray";
        case Verdict::MappedByExtension:
            return "mapped_by_extension";
        case Verdict::RemovedAsOrphan:
            return "removed_as_orphan";
        case Verdict::Kept:
            return "kept";
    }
    return "unknown";
}

std::string_view toString(KeepReason reason) {
    switch (reason) {
        case KeepReason::None:
            return "none";
        case KeepReason::InFrontOfWall:
            return "in_front_of_wall";
        case KeepReason::BehindWall:
            return "behind_wall";
        case KeepReason::NoWallOnRay:
            return "no_wall_on_ray";
        case KeepReason::AmbiguousCorner:
            return "ambiguous_corner";
        case KeepReason::NoPose:
            return "no_pose";
    }
    return "unknown";
}

}  // namespace offmap::core
