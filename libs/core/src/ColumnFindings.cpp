// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnFindings.h"

#include <cmath>

namespace offmap::core {

namespace {

/// Whether two columns have one viewpoint, as all those of a cloud that is taken from one place.
bool isOfOnePlace(const std::optional<SensorPose>& a, const std::optional<SensorPose>& b) {
    return a && b && a->sensorInMap.x() == b->sensorInMap.x() &&
           a->sensorInMap.y() == b->sensorInMap.y() && a->sensorInMap.z() == b->sensorInMap.z() &&
           a->groundCovariance == b->groundCovariance;
}

}  // namespace

ColumnFindings::ColumnFindings(const LineMap& map, const ReductionConfig& config)
    : map_(map),
      config_(config),
      maxMountingSlope_(std::tan(config.groundInterval.maxMountingTilt)),
      finder_(config.vertical) {}

void ColumnFindings::begin() {
    viewpoints_.clear();
    places_.clear();
    sights_.clear();
    firstFault_.reset();
    anyUsable_ = false;
    offMap_ = true;
}

void ColumnFindings::add(const OrganizedScan& scan, ReductionResult& result) {
    const size_t firstSegment = result.segments.size();
    // The paper's method has no need of levelled points once it has a column's segments.
    const bool byColumn = config_.matching.method == MatchingMethod::Paper;
    if (!byColumn) levelled_.resize(scan.points.size());
    for (auto c = static_cast<uint32_t>(viewpoints_.size()); c < scan.columns.size(); ++c) {
        if (byColumn) levelled_.holdOnly(scan.columns[c].begin, scan.columns[c].end);
        levelColumn(scan, c, levelled_);
        finder_.addColumn(scan, levelled_, c, result.segments);  // section 3
        addViewpoint(scan, result);                              // 3.2
        while (result.matches.size() < result.segments.size()) {
            const VerticalSegment& segment = result.segments[result.matches.size()];
            SegmentMatch& match = result.matches.emplace_back();          // Kept, NoPose
            match.measured = groundInterval(segment, maxMountingSlope_);  // eqs. 3-5
        }
    }
    if (config_.matching.method == MatchingMethod::Paper) {
        matchByRays(result, firstSegment);
    } else {
        addSights(scan, result, firstSegment);
    }
}

void ColumnFindings::addViewpoint(const OrganizedScan& scan, ReductionResult& result) {
    const size_t c = viewpoints_.size();
    const ScanColumn& column = scan.columns[c];
    const bool isEmpty = column.begin == column.end;
    if (!isEmpty && c > 0 && viewpoints_[c - 1] &&
        isOfOnePlace(scan.columns[c - 1].sensor, column.sensor)) {
        viewpoints_.push_back(viewpoints_[c - 1]);
        return;
    }
    auto& usable = viewpoints_.emplace_back();
    if (isEmpty) return;
    std::optional<PoseFault> fault = column.fault;
    if (column.sensor) {
        const Viewpoint viewpoint = viewpointOf(*column.sensor);
        fault = faultOf(viewpoint, config_.matching);
        if (!fault) usable = viewpoint;
        // One column with walls around it is enough; mostly, the first has.
        if (!fault && offMap_) {
            offMap_ = !map_.hasWallWithin(viewpoint.position, config_.matching.maxRange);
        }
    }
    if (fault) ++result.columnsWithoutPose;
    if (fault && !firstFault_) firstFault_ = fault;
    anyUsable_ = anyUsable_ || !fault;
}

std::optional<PoseFault> ColumnFindings::notReduced() const {
    if (!anyUsable_) return firstFault_;  // none in a scan without points
    return offMap_ ? std::optional(PoseFault::OffMap) : std::nullopt;
}

/// Eqs. 1, 6, 7.
void ColumnFindings::matchByRays(ReductionResult& result, size_t firstSegment) const {
    for (size_t s = firstSegment; s < result.segments.size(); ++s) {
        const auto& viewpoint = viewpoints_[result.segments[s].column];
        if (!viewpoint) continue;
        matchByRay(result.segments[s], *viewpoint, map_, config_.matching, result.matches[s]);
    }
}

void ColumnFindings::addSights(const OrganizedScan& scan, const ReductionResult& result,
                               size_t firstSegment) {
    addPlaces(scan, places_);
    for (size_t s = firstSegment; s < result.segments.size(); ++s) {
        const VerticalSegment& segment = result.segments[s];
        if (!viewpoints_[segment.column]) continue;
        appendSight(static_cast<uint32_t>(s), segment, scan, levelled_, places_[segment.column],
                    sights_);
    }
}

}  // namespace offmap::core
