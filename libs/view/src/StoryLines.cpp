// SPDX-License-Identifier: BSD-3-Clause
#include "StoryWhy.h"

#include <offmap/view/Wording.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <cmath>

namespace offmap::view {

namespace {

using core::KeepReason;
using core::PointLabel;
using core::Verdict;

std::string metres(const core::Interval& interval) {
    return fmt::format("{:.3f} ... {:.3f} m", interval.min(), interval.max());
}

std::string_view nameOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::MappedByRay:
            return "mapped by ray";
        case Verdict::MappedByExtension:
            return "mapped by extension";
        case Verdict::RemovedAsOrphan:
            return "removed as orphan";
        case Verdict::Kept:
            break;
    }
    return "kept";
}

std::string returnText(const SegmentStory& story) {
    std::string text = fmt::format("{:.3f} m away", story.range);
    if (story.inMap) {
        text += fmt::format(", at ({:.2f}, {:.2f}, {:.2f}) m", story.inMap->x, story.inMap->y,
                            story.inMap->z);
    }
    return text;
}

std::string fateText(PointLabel label) {
    switch (label) {
        case PointLabel::Mapped:
            return "removed: mapped";
        case PointLabel::Orphan:
            return "removed: orphan";
        case PointLabel::Kept:
        case PointLabel::NotOnVerticalSegment:
            break;
    }
    return "kept";
}

std::string predictedText(const SegmentStory& story) {
    if (!story.predicted) return story.wall ? "nothing: the beam grazes the wall" : "no wall";
    return fmt::format("{:.3f} +- {:.3f} m, {}", story.predicted->centre(),
                       0.5 * story.predicted->width(),
                       isOfPrediction(story) ? wallName(story) : "another wall");
}

std::string verdictText(const SegmentStory& story) {
    std::string text{nameOf(story.verdict)};
    if (story.verdict == Verdict::Kept) text += fmt::format(": {}", inWords(story.reason));
    if (story.predicted && isOfPrediction(story)) {
        text += fmt::format(", {:.1f} sigma {}", std::abs(story.residual),
                            story.residual < 0 ? "in front" : "behind");
    }
    return text;
}

/// Where the wall runs, and how well that is known.
std::string wallText(uint32_t index, const core::LineMap& map) {
    if (index >= map.walls().size()) return fmt::format("{}, not in this map", index);
    const core::Wall& wall = map.walls()[index];
    const auto& [a, b] = std::pair(wall.line.point1, wall.line.point2);
    return fmt::format("{}: ({:.2f}, {:.2f}) to ({:.2f}, {:.2f}) m, sigma {:.3f} m", index, a.x,
                       a.y, b.x, b.y, wall.sigma);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> linesOf(const SegmentStory& story,
                                                         const core::LineMap& map) {
    std::vector<std::pair<std::string, std::string>> lines;
    lines.emplace_back("return", returnText(story));
    lines.emplace_back("fate", fateText(story.label));
    lines.emplace_back("column",
                       fmt::format("{} at {:.1f} deg", story.column, mrpt::RAD2DEG(story.azimuth)));
    if (story.segment) {
        lines.emplace_back("segment", fmt::format("{}, {} returns, {} removed", *story.segment,
                                                  story.returns, story.removed));
        lines.emplace_back("height", metres(story.heights));
        lines.emplace_back("measured", metres(*story.measured));
        if (story.reason != KeepReason::NoPose) {
            lines.emplace_back("predicted", predictedText(story));
        }
        lines.emplace_back("verdict", verdictText(story));
    }
    if (story.wall) lines.emplace_back("wall", wallText(*story.wall, map));
    lines.emplace_back("why", whyOf(story));
    return lines;
}

}  // namespace offmap::view
