// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LevelledScan.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/WallSight.h>
#include <offmap/evaluation/SeenSegments.h>

namespace offmap::evaluation {

using core::LevelledScan;
using core::OrganizedScan;
using core::PoseCorrection;
using core::ScanColumn;
using core::VerticalSegment;

namespace {

bool isSeenOver(const VerticalSegment& segment, const ScanColumn& column,
                const LevelledScan& levelled) {
    constexpr double above = 0.05, beyond = 0.3;  // [m]
    constexpr uint32_t few = 3;                   // returns may be mixed pixels or noise
    uint32_t count = 0;
    for (uint32_t i = column.begin; i < column.end; ++i) {
        count += levelled.z[i] > segment.top.y + above &&
                 levelled.range[i] > segment.top.x + beyond;  // (ground range, z)
    }
    return count >= few;
}

Eigen::Matrix2d covarianceOf(const PoseCorrection& correction, const core::WallSight& sight) {
    Eigen::Matrix<double, 2, 5> gradient;
    gradient.row(0) = correction.gradient(sight.place, sight.middle(), {1, 0});
    gradient.row(1) = correction.gradient(sight.place, sight.middle(), {0, 1});
    return gradient * correction.covariance * gradient.transpose();
}

PoseCorrection correctionOf(const OrganizedScan& scan, const core::ReductionResult& result,
                            const core::WallSight& first, const core::ReductionConfig& config) {
    const auto& alignment = result.alignment;
    if (alignment && alignment->fits(config.alignment.minFittedShare)) {
        return alignment->correction;
    }
    const auto& sensor = *scan.columns[result.segments[first.segment].column].sensor;
    return core::uncorrected({sensor.sensorInMap.x(), sensor.sensorInMap.y()},
                             sensor.groundCovariance, config.alignment);
}

}  // namespace

std::vector<SeenSegment> seenSegments(const OrganizedScan& scan,
                                      const core::ReductionResult& result,
                                      const core::ReductionConfig& config) {
    LevelledScan levelled;
    level(scan, levelled);
    std::vector<core::ColumnPlace> places;
    addPlaces(scan, places);
    std::vector<core::WallSight> sights;
    findSights(scan, levelled, places, result.segments, sights);
    std::erase_if(sights, [&](const core::WallSight& sight) {
        const auto& sensor = scan.columns[result.segments[sight.segment].column].sensor;
        return core::faultOf(core::viewpointOf(*sensor), config.matching).has_value();
    });
    std::vector<SeenSegment> seen;
    if (sights.empty()) return seen;
    const PoseCorrection correction = correctionOf(scan, result, sights.front(), config);
    for (const core::WallSight& sight : sights) {
        const VerticalSegment& segment = result.segments[sight.segment];
        const ScanColumn& column = scan.columns[segment.column];
        const double sensorHeight = column.sensor->sensorInMap.z();
        seen.push_back(
            {segment.column, correction.apply(sight.place, {{0, 0}, 0}),
             correction.apply(sight.place, sight.middle()), covarianceOf(correction, sight),
             core::Interval(sensorHeight + segment.bottom.y, sensorHeight + segment.top.y),
             sight.returns, isSeenOver(segment, column, levelled)});
    }
    return seen;
}

}  // namespace offmap::evaluation
