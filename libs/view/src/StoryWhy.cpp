// SPDX-License-Identifier: BSD-3-Clause
#include "StoryWhy.h"

#include <fmt/format.h>

#include <cmath>

namespace offmap::view {

std::string wallName(const SegmentStory& story) {
    return story.wall ? fmt::format("wall {}", *story.wall) : "the wall";
}

bool isOfPrediction(const SegmentStory& story) {
    return story.wall && story.verdict != core::Verdict::MappedByExtension &&
           story.reason != core::KeepReason::AmbiguousCorner;
}

namespace {

using core::KeepReason;
using core::PoseFault;
using core::Verdict;

/// [m] Along the beam, of the segment behind the wall.
double offsetOf(const SegmentStory& story) {
    return story.measured->centre() - story.predicted->centre();
}

const char* sideOf(double offset) { return offset < 0 ? "in front of" : "behind"; }

/// "0.42 m in front of wall 17, which is 3.1 standard deviations"
std::string standing(const SegmentStory& story) {
    const double offset = offsetOf(story);
    return fmt::format("{:.2f} m {} {}, which is {:.1f} standard deviations", std::abs(offset),
                       sideOf(offset), wallName(story), std::abs(story.residual));
}

std::string_view whyNoPose(PoseFault fault) {
    switch (fault) {
        case PoseFault::NoPose:
            return "No pose is known for this time";
        case PoseFault::TooOld:
            return "The nearest pose is too far away in time";
        case PoseFault::NotFinite:
            return "The pose or its covariance is not finite";
        case PoseFault::NotPsd:
            return "The covariance of the pose is not positive semidefinite";
        case PoseFault::TooUncertain:
            return "The pose is too uncertain: any segment would fit some wall";
        case PoseFault::OffMap:
            return "No wall of the map is within range of the sensor";
        case PoseFault::DoesNotFit:
            return "What the scan shows fits the map nowhere that the pose allows";
    }
    return "The pose cannot be used";
}

/// Why a segment stays that the ray through it says to stand before or behind a wall.
std::string whyOffWall(const SegmentStory& story) {
    if (!story.predicted) {
        return fmt::format("The beam only grazes {}, and the segment does not stand on it: kept.",
                           wallName(story));
    }
    // Within the gate of the wall's line, but past its end or at its corner.
    if (story.predicted->contains(story.measured->centre())) {
        return fmt::format("Along the beam it stands {}, but the wall itself is not there: kept.",
                           standing(story));
    }
    return fmt::format("It stands {}: not the wall.", standing(story));
}

std::string whyKept(const SegmentStory& story) {
    switch (story.reason) {
        case KeepReason::InFrontOfWall:
        case KeepReason::BehindWall:
            return whyOffWall(story);
        case KeepReason::NoWallOnRay:
            return "No wall lies in this direction.";
        case KeepReason::AmbiguousCorner:
            return fmt::format(
                "It fits {} only if the heading is wrong by as much as it may be: in doubt, kept.",
                wallName(story));
        case KeepReason::NoPose:
        case KeepReason::None:
            break;
    }
    return "Its column has no pose to be trusted: kept.";
}

std::string whyMapped(const SegmentStory& story) {
    switch (story.verdict) {
        case Verdict::MappedByRay:
            if (!story.predicted) {
                return fmt::format("It stands on {}: the map knows it.", wallName(story));
            }
            return fmt::format(
                "It stands on {}, {:.2f} m {} it, which is {:.1f} standard deviations: the map "
                "knows it.",
                wallName(story), std::abs(offsetOf(story)), sideOf(offsetOf(story)),
                std::abs(story.residual));
        case Verdict::MappedByExtension:
            return fmt::format("It continues the line of mapped segments along {}.",
                               wallName(story));
        case Verdict::RemovedAsOrphan:
            return "No other segment stands beside it: removed as an orphan, as asked for.";
        case Verdict::Kept:
            break;
    }
    return whyKept(story);
}

}  // namespace

std::string whyOf(const SegmentStory& story) {
    if (story.fault && !core::isRemoved(story.label))
        return fmt::format("{}: kept.", whyNoPose(*story.fault));
    if (!story.segment) {
        return core::isRemoved(story.label)
                   ? "On no vertical segment, but it lies on a wall that segments beside it were "
                     "matched to: removed with them."
                   : "Not on a vertical segment: neither wall nor object edge; always kept.";
    }
    if (story.verdict != Verdict::Kept && !core::isRemoved(story.label)) {
        return fmt::format(
            "Its segment was matched to {}, but this return stands off the wall: kept.",
            wallName(story));
    }
    return whyMapped(story);
}

}  // namespace offmap::view
