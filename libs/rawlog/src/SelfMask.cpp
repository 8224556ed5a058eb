// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SelfMask.h>

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <limits>
#include <span>
#include <vector>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3D;

/// In place of the number of a point that is taken out.
constexpr uint32_t masked = std::numeric_limits<uint32_t>::max();

bool holds(const RobotBox& box, const TPoint3D& p) {
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y &&
           box.min.z <= p.z && p.z <= box.max.z;
}

/// Closes the gaps in points, source indices and columns, from the column on. \return the new
/// number of each point behind `firstPoint`
std::vector<uint32_t> takeOutOwnPoints(core::OrganizedScan& scan, const SensorConfig& config,
                                       size_t firstColumn, uint32_t firstPoint) {
    const double squaredMinRange = config.minRange * config.minRange;
    std::vector<uint32_t> numbers(scan.points.size() - firstPoint, masked);
    uint32_t kept = firstPoint;
    for (core::ScanColumn& column : std::span(scan.columns).subspan(firstColumn)) {
        const mrpt::poses::CPose3D sensorInVehicle(column.sensorInVehicle);
        const uint32_t begin = kept;
        for (uint32_t i = column.begin; i < column.end; ++i) {
            const TPoint3D pointInSensor(scan.points[i]);
            if (pointInSensor.sqrNorm() < squaredMinRange) continue;
            if (config.robotBox &&
                holds(*config.robotBox, sensorInVehicle.composePoint(pointInSensor))) {
                continue;
            }
            numbers[i - firstPoint] = kept;
            scan.points[kept] = scan.points[i];
            scan.sourceIndex[kept++] = scan.sourceIndex[i];
        }
        column.begin = begin;
        column.end = kept;
    }
    scan.points.resize(kept);
    scan.sourceIndex.resize(kept);
    return numbers;
}

}  // namespace

void maskSelfReturns(TurnScan& turn, const SensorConfig& config, size_t firstColumn) {
    if (config.minRange <= 0 && !config.robotBox) return;
    if (firstColumn == turn.scan.columns.size()) return;
    const size_t before = turn.scan.points.size() + turn.duplicates.size();
    const uint32_t firstPoint = turn.scan.columns[firstColumn].begin;
    const auto numbers = takeOutOwnPoints(turn.scan, config, firstColumn, firstPoint);
    for (DuplicateReturn& duplicate : turn.duplicates) {
        if (duplicate.point >= firstPoint) duplicate.point = numbers[duplicate.point - firstPoint];
    }
    std::erase_if(turn.duplicates, [](const DuplicateReturn& d) { return d.point == masked; });
    turn.counts.self += before - turn.scan.points.size() - turn.duplicates.size();
}

}  // namespace offmap::rawlog
