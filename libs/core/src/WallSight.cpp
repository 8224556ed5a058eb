// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>
#include <offmap/core/WallSight.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// Of returns, about their centre.
struct Moments {
    double height;          // [m] their mean
    double variance;        // [m^2] of the heights, times the number of returns
    double alongX, alongY;  // [m^2] covariance of place and height, times that number
};

OFFMAP_BY_PROCESSOR Moments momentsOf(const float* x, const float* y, const float* z,
                                      uint32_t count, double centreX, double centreY) {
    const uint32_t blocks = count / doubleLaneCount * doubleLaneCount;
    DoubleLanes heights{}, squares{}, alongX{}, alongY{}, east, north, up;
    for (uint32_t i = 0; i < blocks; i += doubleLaneCount) {
        load(z + i, up);
        heights += up;
    }
    double height = total(heights);
    for (uint32_t i = blocks; i < count; ++i) height += static_cast<double>(z[i]);
    height /= count;
    for (uint32_t i = 0; i < blocks; i += doubleLaneCount) {
        load(x + i, east);
        load(y + i, north);
        load(z + i, up);
        squares += (up - height) * (up - height);
        alongX += (east - centreX) * (up - height);
        alongY += (north - centreY) * (up - height);
    }
    Moments moments{height, total(squares), total(alongX), total(alongY)};
    for (uint32_t i = blocks; i < count; ++i) {
        const double above = static_cast<double>(z[i]) - height;
        moments.variance += above * above;
        moments.alongX += (static_cast<double>(x[i]) - centreX) * above;
        moments.alongY += (static_cast<double>(y[i]) - centreY) * above;
    }
    return moments;
}

/// Regression of the returns' places on their heights.
class HeightRegression {
 public:
    HeightRegression(const VerticalSegment& segment, const LevelledScan& levelled)
        : centre_(segment.centre) {
        const uint32_t begin = segment.begin, count = segment.end - begin;
        const Moments moments = momentsOf(levelled.x.data() + begin, levelled.y.data() + begin,
                                          levelled.z.data() + begin, count, centre_.x, centre_.y);
        meanHeight_ = moments.height;
        deviation_ = std::sqrt(moments.variance / count);
        if (!(moments.variance > 0)) return;
        perDeviation_ = TPoint2D(moments.alongX, moments.alongY) * (deviation_ / moments.variance);
    }

    double meanHeight() const { return meanHeight_; }
    SeenPoint below() const { return {centre_ - perDeviation_, meanHeight_ - deviation_}; }
    SeenPoint above() const { return {centre_ + perDeviation_, meanHeight_ + deviation_}; }

 private:
    TPoint2D centre_;
    double meanHeight_, deviation_;   // [m]
    TPoint2D perDeviation_ = {0, 0};  // [m] shift on the ground per standard deviation of height
};

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

void appendSight(uint32_t index, const VerticalSegment& segment, const OrganizedScan& scan,
                 const LevelledScan& levelled, const ColumnPlace& place,
                 std::vector<WallSight>& sights) {
    const double range = segment.centre.norm();
    if (!(range > 0)) return;
    const HeightRegression line(segment, levelled);
    WallSight& sight = sights.emplace_back();  // in place: what is copied has to wait to be written
    sight.segment = index;
    sight.place = place;
    sight.lower = line.below();
    sight.upper = line.above();
    sight.beam = segment.centre * (1 / range);
    const double sensorHeight = scan.columns[segment.column].sensor->sensorInMap.z();
    sight.heightInMap = sensorHeight + line.meanHeight();
    sight.returns = segment.end - segment.begin;
    sight.rangeSigma = rangeSigmaOf(scan, segment);
}

void findSights(const OrganizedScan& scan, const LevelledScan& levelled,
                std::span<const ColumnPlace> places, std::span<const VerticalSegment> segments,
                std::vector<WallSight>& sights) {
    sights.clear();
    for (uint32_t s = 0; s < segments.size(); ++s) {
        const VerticalSegment& segment = segments[s];
        if (!scan.columns[segment.column].sensor) continue;
        appendSight(s, segment, scan, levelled, places[segment.column], sights);
    }
}

}  // namespace offmap::core
