// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallSight.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// Regression of the returns' places on their heights.
WallSight sightOf(const VerticalSegment& segment, uint32_t index, const ColumnPlace& place,
                  const LevelledScan& levelled, double sensorHeight) {
    const uint32_t count = segment.end - segment.begin;
    double meanHeight = 0;
    for (uint32_t i = segment.begin; i < segment.end; ++i) meanHeight += levelled.profile[i].y;
    meanHeight /= count;
    double variance = 0;
    TPoint2D slope(0, 0);
    for (uint32_t i = segment.begin; i < segment.end; ++i) {
        const double above = levelled.profile[i].y - meanHeight;
        variance += above * above;
        slope += (levelled.ground[i] - segment.centre) * above;
    }
    if (variance > 0) slope = slope * (1 / variance);
    const double deviation = std::sqrt(variance / count);
    return {index,
            place,
            {segment.centre - slope * deviation, meanHeight - deviation},
            {segment.centre + slope * deviation, meanHeight + deviation},
            segment.centre * (1 / segment.centre.norm()),
            sensorHeight + meanHeight,
            count};
}

std::optional<double> rangeSigmaOf(const OrganizedScan& scan, const VerticalSegment& segment) {
    if (scan.rangeSigma.empty()) return std::nullopt;
    double sum = 0;
    for (uint32_t i = segment.begin; i < segment.end; ++i) {
        const double sigma = scan.rangeSigma[i];
        sum += sigma * sigma;
    }
    return std::sqrt(sum / (segment.end - segment.begin));
}

}  // namespace

void findSights(const OrganizedScan& scan, const LevelledScan& levelled,
                std::span<const ColumnPlace> places, std::span<const VerticalSegment> segments,
                std::vector<WallSight>& sights) {
    sights.clear();
    for (uint32_t s = 0; s < segments.size(); ++s) {
        const VerticalSegment& segment = segments[s];
        const auto& sensor = scan.columns[segment.column].sensor;
        if (!sensor || !(segment.centre.norm() > 0)) continue;
        sights.push_back(
            sightOf(segment, s, places[segment.column], levelled, sensor->sensorInMap.z()));
        sights.back().rangeSigma = rangeSigmaOf(scan, segment);
    }
}

}  // namespace offmap::core
