// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/SweepColumns.h>
#include <offmap/rawlog/SweepFan.h>

#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3Df;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;

/// [rad] A beam may lie past the vertical by that much and still belong to its own column.
constexpr double verticalTolerance = 1e-3;

struct SweepColumn {
    core::ScanColumn place;
    const CPose3D* sensorInVehicle = nullptr;
    std::vector<ColumnReturn> own, opposite;  ///< this side, past the vertical; own frame
};

const CObservation2DRangeScan& asScan(const mrpt::obs::CObservation& obs) {
    return dynamic_cast<const CObservation2DRangeScan&>(obs);
}

PoseReference resolve(PoseReference reference, const Turn& turn) {
    if (reference != PoseReference::Auto) return reference;
    constexpr double tolerance = 1e-3;  // [m]
    const CPose3D& first = asScan(*turn.front()).sensorPose;
    double minX = first.x(), maxX = first.x(), minY = first.y(), maxY = first.y();
    for (const auto& obs : turn) {
        const CPose3D& pose = asScan(*obs).sensorPose;
        minX = std::min(minX, pose.x());
        maxX = std::max(maxX, pose.x());
        minY = std::min(minY, pose.y());
        maxY = std::max(maxY, pose.y());
    }
    const bool moves = maxX - minX > tolerance || maxY - minY > tolerance;
    return moves ? PoseReference::Turn : PoseReference::Column;
}

std::vector<SweepColumn> placeColumns(const Turn& turn, const PoseSource& poses,
                                      const SensorConfig& config, FanAxis axis) {
    const bool onePose = resolve(config.poseReference, turn) == PoseReference::Turn;
    const PoseLookup ofTurn = poses.at(turn.front()->timestamp);
    std::vector<SweepColumn> columns(turn.size());
    for (size_t c = 0; c < turn.size(); ++c) {
        const auto& scan = asScan(*turn[c]);
        columns[c].place.azimuth = static_cast<float>(fanAzimuth(scan, axis));
        columns[c].place.time = scan.timestamp;
        columns[c].sensorInVehicle = &scan.sensorPose;
        placeColumn(columns[c].place, onePose ? ofTurn : poses.at(scan.timestamp), scan.sensorPose);
    }
    return columns;
}

/// \param firstSlot of this scan in the turn
void takeRays(const CObservation2DRangeScan& scan, const std::vector<TPoint2D>& beams, FanAxis axis,
              size_t firstSlot, SweepColumn& column, ReturnCounts& counts) {
    const TPoint2D along = fanDirection(scan, axis);
    const auto& rotation = scan.sensorPose.getRotationMatrix();
    // The fan's horizontal direction in the frame of the sensor; it lies in the plane z = 0.
    const TPoint2D alongInSensor(rotation(0, 0) * along.x + rotation(1, 0) * along.y,
                                 rotation(0, 1) * along.x + rotation(1, 1) * along.y);
    for (size_t i = 0; i < beams.size(); ++i) {
        const float range = scan.getScanRange(i);
        if (!scan.getScanRangeValidity(i) || range <= 0) {
            ++counts.zero;
            continue;
        }
        const TPoint3Df point(static_cast<float>(range * beams[i].x),
                              static_cast<float>(range * beams[i].y), 0);
        if (!countReturn(counts, point)) continue;
        const double forward = beams[i].x * alongInSensor.x + beams[i].y * alongInSensor.y;
        auto& side = forward >= -verticalTolerance ? column.own : column.opposite;
        side.push_back({point, static_cast<uint32_t>(firstSlot + i)});
    }
}

double step(const SweepColumn& a, const SweepColumn& b) {
    return std::abs(mrpt::math::wrapToPi(static_cast<double>(b.place.azimuth - a.place.azimuth)));
}

/// Median azimuth step [rad] between columns that differ in azimuth; 0 if none do.
double medianStep(const std::vector<SweepColumn>& columns) {
    std::vector<double> steps;
    for (size_t c = 1; c < columns.size(); ++c) {
        const double s = step(columns[c - 1], columns[c]);
        if (s > 1e-4) steps.push_back(s);
    }
    if (steps.empty()) return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Finds the column that looks the opposite way.
class OppositeColumns {
 public:
    explicit OppositeColumns(const std::vector<SweepColumn>& columns)
        : reach_(1.5 * medianStep(columns)) {
        for (size_t c = 0; c < columns.size(); ++c) {
            sorted_.emplace_back(columns[c].place.azimuth, c);
        }
        std::sort(sorted_.begin(), sorted_.end());
    }

    std::optional<size_t> of(const SweepColumn& column) const {
        const double wanted = mrpt::math::wrapToPi(column.place.azimuth + std::numbers::pi);
        const auto above = std::lower_bound(sorted_.begin(), sorted_.end(),
                                            std::pair(static_cast<float>(wanted), size_t{0}));
        const auto& next = above == sorted_.end() ? sorted_.front() : *above;
        const auto& previous = above == sorted_.begin() ? sorted_.back() : *std::prev(above);
        const auto off = [&](const auto& candidate) {
            return std::abs(mrpt::math::wrapToPi(candidate.first - wanted));
        };
        const auto& nearest = off(next) < off(previous) ? next : previous;
        if (off(nearest) > reach_) return {};
        return nearest.second;
    }

 private:
    double reach_;                                  ///< [rad]
    std::vector<std::pair<float, size_t>> sorted_;  ///< azimuth [rad], column
};

CPose3D ownInTarget(const SweepColumn& own, const SweepColumn& target) {
    if (own.place.sensor && target.place.sensor) {
        return own.place.sensor->sensorInMap - target.place.sensor->sensorInMap;
    }
    return *own.sensorInVehicle - *target.sensorInVehicle;
}

void moveOpposite(SweepColumn& from, SweepColumn& to) {
    const CPose3D fromInTo = ownInTarget(from, to);
    for (const ColumnReturn& r : from.opposite) {
        mrpt::math::TPoint3D moved;
        fromInTo.composePoint(r.point, moved);
        to.own.push_back({moved.cast<float>(), r.slot});
    }
    from.opposite.clear();
}

}  // namespace

TurnScan organizeSweep(const Turn& turn, const PoseSource& poses, const SensorConfig& config) {
    TurnScan out;
    if (turn.empty()) return out;
    const FanAxis axis = chooseFanAxis(asScan(*turn.front()));
    std::vector<SweepColumn> columns = placeColumns(turn, poses, config, axis);

    BeamDirections beams;
    size_t firstSlot = 0;
    for (size_t c = 0; c < turn.size(); ++c) {
        const auto& scan = asScan(*turn[c]);
        takeRays(scan, beams.of(scan), axis, firstSlot, columns[c], out.counts);
        firstSlot += scan.getScanSize();
    }

    const OppositeColumns opposites(columns);
    for (SweepColumn& column : columns) {
        if (column.opposite.empty()) continue;
        if (const auto target = opposites.of(column)) moveOpposite(column, columns[*target]);
    }
    for (SweepColumn& c : columns) appendColumn(out, c.place, *c.sensorInVehicle, c.own);
    for (SweepColumn& c : columns) {
        if (c.opposite.empty()) continue;
        c.place.azimuth =
            static_cast<float>(mrpt::math::wrapToPi(c.place.azimuth + std::numbers::pi));
        appendColumn(out, c.place, *c.sensorInVehicle, c.opposite);
    }
    return out;
}

}  // namespace offmap::rawlog
