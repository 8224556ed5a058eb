// SPDX-License-Identifier: BSD-3-Clause
#include "Lanes.h"

#include <offmap/core/WallSight.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// Regression of the returns' places on their heights.
class HeightRegression {
 public:
    HeightRegression(const VerticalSegment& segment, const LevelledScan& levelled)
        : centre_(segment.centre) {
        const uint32_t count = segment.end - segment.begin;
        meanHeight_ = sumOf(std::span(levelled.z).subspan(segment.begin, count)) / count;
        uint32_t i = segment.begin;
        Lanes squares = Lanes::Zero(), alongX = squares, alongY = squares;
        for (; i + laneCount <= segment.end; i += laneCount) {
            const Lanes above = lanesAt(levelled.z.data() + i) - meanHeight_;
            squares += above * above;
            alongX += (lanesAt(levelled.x.data() + i) - centre_.x) * above;
            alongY += (lanesAt(levelled.y.data() + i) - centre_.y) * above;
        }
        double variance = squares.sum();
        TPoint2D slope(alongX.sum(), alongY.sum());
        for (; i < segment.end; ++i) {
            const double above = levelled.z[i] - meanHeight_;
            variance += above * above;
            slope += (levelled.ground(i) - centre_) * above;
        }
        deviation_ = std::sqrt(variance / count);
        perDeviation_ = variance > 0 ? slope * (deviation_ / variance) : TPoint2D(0, 0);
    }

    double meanHeight() const { return meanHeight_; }
    SeenPoint below() const { return {centre_ - perDeviation_, meanHeight_ - deviation_}; }
    SeenPoint above() const { return {centre_ + perDeviation_, meanHeight_ + deviation_}; }

 private:
    TPoint2D centre_;
    double meanHeight_, deviation_;  // [m]
    TPoint2D perDeviation_;          // [m] shift on the ground per standard deviation of height
};

WallSight sightOf(const VerticalSegment& segment, uint32_t index, const ColumnPlace& place,
                  const LevelledScan& levelled, double sensorHeight) {
    const HeightRegression line(segment, levelled);
    return {index,
            place,
            line.below(),
            line.above(),
            segment.centre * (1 / segment.centre.norm()),
            sensorHeight + line.meanHeight(),
            segment.end - segment.begin};
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
