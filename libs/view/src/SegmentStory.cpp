// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/SegmentStory.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace offmap::view {

namespace {

/// Why a column's pose could not be used, although it has one.
core::PoseFault faultOf(const core::SensorPose& sensor) {
    const auto& inMap = sensor.sensorInMap;
    const bool finite = std::isfinite(inMap.x()) && std::isfinite(inMap.y()) &&
                        std::isfinite(inMap.z()) && sensor.groundCovariance.allFinite();
    return finite ? core::PoseFault::TooUncertain : core::PoseFault::NotFinite;
}

uint32_t columnOf(const core::OrganizedScan& scan, uint32_t point) {
    const auto after = std::ranges::upper_bound(scan.columns, point, {}, &core::ScanColumn::begin);
    if (after == scan.columns.begin() || point >= std::prev(after)->end) {
        throw std::out_of_range("storyOf: no column of the scan holds this point");
    }
    return static_cast<uint32_t>(std::prev(after) - scan.columns.begin());
}

/// z [m] of the sensor that the segments' heights count from.
double heightOf(const core::ScanColumn& column) {
    return column.sensor ? column.sensor->sensorInMap.z() : column.sensorInVehicle.z;
}

void tellOfSegment(const core::ReductionResult& result, uint32_t index,
                   const core::ScanColumn& column, SegmentStory& story) {
    const core::VerticalSegment& segment = result.segments[index];
    const core::SegmentMatch& match = result.matches.at(index);
    const double height = heightOf(column);
    const auto [low, high] = std::minmax(segment.bottom.y, segment.top.y);
    story.segment = index;
    story.heights = {height + low, height + high};
    story.measured = match.measured;
    story.predicted = match.predicted;
    story.residual = match.residual;
    story.wall = match.wall;
    story.verdict = match.verdict;
    story.reason = match.reason;
    story.returns = segment.end - segment.begin;
    story.removed = static_cast<uint32_t>(
        std::count_if(result.labels.begin() + segment.begin, result.labels.begin() + segment.end,
                      [](core::PointLabel label) { return core::isRemoved(label); }));
    if (!story.fault && column.sensor && match.reason == core::KeepReason::NoPose) {
        story.fault = faultOf(*column.sensor);
    }
}

}  // namespace

std::optional<uint32_t> segmentOf(const core::ReductionResult& result, uint32_t point) {
    const auto after =
        std::ranges::upper_bound(result.segments, point, {}, &core::VerticalSegment::begin);
    if (after == result.segments.begin() || point >= std::prev(after)->end) return std::nullopt;
    return static_cast<uint32_t>(std::prev(after) - result.segments.begin());
}

SegmentStory storyOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                     uint32_t point) {
    SegmentStory story;
    const auto& inSensor = scan.points.at(point);
    if (result.labels.size() != scan.points.size()) {
        throw std::out_of_range("storyOf: the result has not one label per point of the scan");
    }
    story.point = point;
    story.column = columnOf(scan, point);
    const core::ScanColumn& column = scan.columns[story.column];
    story.azimuth = static_cast<double>(column.azimuth);
    story.range = static_cast<double>(inSensor.norm());
    story.label = result.labels[point];
    const mrpt::math::TPoint3D own(inSensor);
    if (column.sensor) {
        story.inMap = column.sensor->sensorInMap.composePoint(own);
        story.fault = result.notReduced;
    } else {
        story.fault = column.fault;
    }
    const double z = story.inMap ? story.inMap->z : column.sensorInVehicle.composePoint(own).z;
    if (std::isfinite(z)) story.heights = {z, z};
    if (const auto segment = segmentOf(result, point)) {
        tellOfSegment(result, *segment, column, story);
    }
    return story;
}

}  // namespace offmap::view
