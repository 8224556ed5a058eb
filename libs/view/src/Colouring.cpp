// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Colouring.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

namespace offmap::view {

namespace {

using mrpt::img::TColor;

constexpr uint32_t none = std::numeric_limits<uint32_t>::max();

/// Per point of the scan the segment that it lies on, or none.
std::vector<uint32_t> segmentOfEach(const core::ReductionResult& result, size_t points) {
    std::vector<uint32_t> segments(points, none);
    for (uint32_t s = 0; s < result.segments.size(); ++s) {
        const auto& segment = result.segments[s];
        std::fill(segments.begin() + segment.begin, segments.begin() + segment.end, s);
    }
    return segments;
}

template <class Colour>
std::vector<TColor> forEach(const PlacedReturns& returns, const Colour& colour) {
    std::vector<TColor> colours;
    colours.reserve(returns.points.size());
    for (size_t i = 0; i < returns.points.size(); ++i) colours.push_back(colour(i));
    return colours;
}

/// But the 2 % at either end.
std::optional<core::Interval> withoutOutermost(std::vector<float>& values) {
    if (values.empty()) return std::nullopt;
    const auto cut = static_cast<std::ptrdiff_t>(values.size() / 50);
    const auto at = [&](std::vector<float>::iterator place) {
        std::nth_element(values.begin(), place, values.end());
        return static_cast<double>(*place);
    };
    return core::Interval(at(values.begin() + cut), at(values.end() - 1 - cut));
}

std::vector<TColor> byHeight(const PlacedReturns& returns) {
    if (returns.points.empty()) return {};
    const core::Interval heights = colouredHeights(returns);
    const double range = std::max(heights.width(), 1e-3);
    return forEach(returns, [&](size_t i) {
        return sequential((static_cast<double>(returns.points[i].z) - heights.min()) / range);
    });
}

}  // namespace

core::Interval colouredHeights(const PlacedReturns& returns) {
    std::vector<float> heights;
    heights.reserve(returns.points.size());
    for (const auto& point : returns.points)
        if (std::isfinite(point.z)) heights.push_back(point.z);
    return withoutOutermost(heights).value_or(core::Interval(0, 0));
}

core::Interval colouredIntensities(std::span<const float> intensities) {
    std::vector<float> known;
    known.reserve(intensities.size());
    std::ranges::copy_if(intensities, std::back_inserter(known),
                         [](float intensity) { return std::isfinite(intensity); });
    const auto most = withoutOutermost(known);
    return {0, most && most->max() > 0 ? most->max() : 1.0};
}

std::vector<TColor> coloursOf(const PlacedReturns& returns, const core::OrganizedScan& scan,
                              const core::ReductionResult& result, ColourBy colourBy,
                              const Palette& palette, std::span<const float> intensities) {
    if (colourBy == ColourBy::Height) return byHeight(returns);
    const auto byLabel = [&](size_t i) { return palette.of(returns.labels[i]); };
    if (colourBy == ColourBy::Label) return forEach(returns, byLabel);
    if (colourBy == ColourBy::Intensity) {
        const double brightest = colouredIntensities(intensities).max();
        return forEach(returns, [&](size_t i) {
            const uint32_t point = returns.indices[i];
            const bool known = point < intensities.size() && std::isfinite(intensities[point]);
            return known ? sequential(static_cast<double>(intensities[point]) / brightest)
                         : palette.rest;
        });
    }
    const std::vector<uint32_t> segments = segmentOfEach(result, scan.points.size());
    return forEach(returns, [&](size_t i) {
        const uint32_t segment = segments[returns.indices[i]];
        if (segment == none) {
            return colourBy == ColourBy::Residual ? palette.rest : byLabel(i);
        }
        const core::SegmentMatch& match = result.matches[segment];
        if (colourBy == ColourBy::Residual) {
            return match.predicted ? diverging(match.residual / colouredResidual) : palette.rest;
        }
        return match.verdict == core::Verdict::Kept ? palette.of(match.reason) : byLabel(i);
    });
}

}  // namespace offmap::view
