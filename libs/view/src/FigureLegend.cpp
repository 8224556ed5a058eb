// SPDX-License-Identifier: BSD-3-Clause
#include "FigureLegend.h"

#include <offmap/view/SegmentStory.h>
#include <offmap/view/Wording.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace offmap::view {

namespace {

using core::KeepReason;
using core::PointLabel;
using Entries = std::vector<LegendEntry>;
using Mark = LegendEntry::Mark;

/// 12,345
std::string grouped(size_t count) {
    std::string text = std::to_string(count);
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3) {
        text.insert(text.begin() + i, ',');
    }
    return text;
}

size_t countOf(const PlacedReturns& returns, PointLabel label) {
    return static_cast<size_t>(std::ranges::count(returns.labels, label));
}

void addLabel(Entries& entries, const PlacedReturns& returns, const SceneOptions& options,
              PointLabel label, const char* meaning) {
    const char* hidden = isShown(label, options) ? "" : ", hidden";
    entries.push_back({fmt::format("{}{} {}", meaning, hidden, grouped(countOf(returns, label))),
                       options.palette.of(label)});
}

void addLabels(Entries& entries, const PlacedReturns& returns, const SceneOptions& options) {
    addLabel(entries, returns, options, PointLabel::Mapped, "mapped, removed");
    addLabel(entries, returns, options, PointLabel::Kept, "kept segment");
    if (countOf(returns, PointLabel::Orphan) > 0) {
        addLabel(entries, returns, options, PointLabel::Orphan, "orphan, removed");
    }
    addLabel(entries, returns, options, PointLabel::NotOnVerticalSegment,
             "not on a vertical segment");
}

/// Those of segments that were kept, by reason. Returns that were kept off a removed segment stand
/// in front of its wall.
std::array<size_t, core::keepReasonCount> countReasons(const PlacedReturns& returns,
                                                       const core::ReductionResult& result) {
    std::array<size_t, core::keepReasonCount> counts{};
    for (size_t i = 0; i < returns.labels.size(); ++i) {
        if (returns.labels[i] != PointLabel::Kept) continue;
        const auto segment = segmentOf(result, returns.indices[i]);
        const KeepReason reason = segment ? result.matches[*segment].reason : KeepReason::None;
        ++counts.at(
            static_cast<size_t>(reason == KeepReason::None ? KeepReason::InFrontOfWall : reason));
    }
    return counts;
}

void addReasons(Entries& entries, const PlacedReturns& returns, const core::ReductionResult& result,
                const SceneOptions& options) {
    addLabel(entries, returns, options, PointLabel::Mapped, "mapped, removed");
    const auto counts = countReasons(returns, result);
    for (const KeepReason reason : keepReasons) {
        const size_t count = counts.at(static_cast<size_t>(reason));
        if (count == 0) continue;
        entries.push_back(
            {fmt::format("{} {}", inWords(reason), grouped(count)), options.palette.of(reason)});
    }
    if (countOf(returns, PointLabel::Orphan) > 0) {
        addLabel(entries, returns, options, PointLabel::Orphan, "orphan, removed");
    }
    addLabel(entries, returns, options, PointLabel::NotOnVerticalSegment,
             "not on a vertical segment");
}

mrpt::img::TColor residualAt(double share) { return diverging(2 * share - 1); }

size_t countUnknown(const PlacedReturns& returns, const std::vector<float>& intensities) {
    return static_cast<size_t>(std::ranges::count_if(returns.indices, [&](uint32_t point) {
        return point >= intensities.size() || !std::isfinite(intensities[point]);
    }));
}

void addIntensity(Entries& entries, const PlacedReturns& returns, const FigureOptions& options) {
    const double most = colouredIntensities(options.intensities).max();
    entries.push_back({fmt::format("{:.2f}", most), {}, Mark::Scale, "intensity 0", sequential});
    const size_t unknown = countUnknown(returns, options.intensities);
    if (unknown > 0) {
        entries.push_back({"not told " + grouped(unknown), options.scene.palette.rest});
    }
}

void addResidual(Entries& entries, const PlacedReturns& returns,
                 const core::ReductionResult& result, const FigureOptions& options) {
    const auto most = static_cast<int>(colouredResidual);
    entries.push_back({fmt::format("+{} standard deviations behind the wall", most),
                       {},
                       Mark::Scale,
                       fmt::format("in front -{}", most),
                       residualAt});
    const auto compared = [&](uint32_t point) {
        const auto segment = segmentOf(result, point);
        return segment && result.matches[*segment].predicted;
    };
    const auto with = static_cast<size_t>(std::ranges::count_if(returns.indices, compared));
    entries.push_back({"compared with no wall " + grouped(returns.indices.size() - with),
                       options.scene.palette.rest});
}

void addColours(Entries& entries, const PlacedReturns& returns, const core::ReductionResult& result,
                const FigureOptions& options) {
    switch (options.colourBy) {
        case ColourBy::Label:
            return addLabels(entries, returns, options.scene);
        case ColourBy::Reason:
            return addReasons(entries, returns, result, options.scene);
        case ColourBy::Residual:
            return addResidual(entries, returns, result, options);
        case ColourBy::Intensity:
            return addIntensity(entries, returns, options);
        case ColourBy::Height: {
            const core::Interval heights = colouredHeights(returns);
            entries.push_back({fmt::format("{:.1f} m", heights.max()),
                               {},
                               Mark::Scale,
                               fmt::format("height {:.1f} m", heights.min()),
                               sequential});
            return;
        }
    }
}

void addPoses(Entries& entries, const core::OrganizedScan& scan,
              const core::ReductionResult& result, const Palette& palette) {
    const bool posed = std::ranges::any_of(
        scan.columns, [](const core::ScanColumn& column) { return column.sensor.has_value(); });
    if (!posed) return;
    entries.push_back({"pose as given, 3 sigma", palette.sensor, Mark::Line});
    if (!result.alignment) return;
    const bool fits = result.notReduced != core::PoseFault::DoesNotFit;
    entries.push_back(
        {fits ? "as refined" : "as refined, does not fit", palette.refined, Mark::Line});
}

}  // namespace

std::vector<LegendEntry> legendOf(const PlacedReturns& returns, const core::OrganizedScan& scan,
                                  const core::ReductionResult& result,
                                  const FigureOptions& options) {
    Entries entries;
    addColours(entries, returns, result, options);
    const bool byLabel =
        options.colourBy == ColourBy::Label || options.colourBy == ColourBy::Reason;
    if (!byLabel && !options.scene.showMapped) {
        const size_t hidden =
            countOf(returns, PointLabel::Mapped) + countOf(returns, PointLabel::Orphan);
        entries.push_back({"removed, hidden " + grouped(hidden), options.scene.palette.background});
    }
    if (options.scene.showWalls) {
        entries.push_back({"map", options.scene.palette.wall, Mark::Line});
    }
    if (options.scene.showPoses) addPoses(entries, scan, result, options.scene.palette);
    return entries;
}

}  // namespace offmap::view
