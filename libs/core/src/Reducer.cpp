// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/HorizontalExtension.h>
#include <offmap/core/LevelledScan.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/OrphanRemoval.h>
#include <offmap/core/PointLevel.h>
#include <offmap/core/Reducer.h>
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/VerticalSegments.h>
#include <offmap/core/WallGate.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

struct Reducer::Workspace {
    LevelledScan levelled;
    SplitAndMergeScratch splitting;
    std::vector<std::optional<Viewpoint>> viewpoints;  // per column
    SegmentsByColumn byColumn;
    ExtensionScratch extension;
    std::vector<ColumnPlace> places;
    std::vector<WallSight> sights;
    AlignmentScratch alignment;
    LooseReturnsScratch looseReturns;
    ReductionResult result;

    void findViewpoints(const OrganizedScan& scan, const LineMap& map,
                        const MatchingConfig& config);
    void measureSegments(const ReductionConfig& config);
    void matchByRays(const LineMap& map, const ReductionConfig& config);
    std::optional<PoseCorrection> correct(const OrganizedScan& scan, const LineMap& map,
                                          const ReductionConfig& config);
    void matchByGates(const PoseCorrection& correction, const LineMap& map,
                      const ReductionConfig& config);
    void labelPoints(size_t points);
};

/// A viewpoint for every column whose pose can be used; else the reason, if that goes for the whole
/// scan.
void Reducer::Workspace::findViewpoints(const OrganizedScan& scan, const LineMap& map,
                                        const MatchingConfig& config) {
    viewpoints.assign(scan.columns.size(), std::nullopt);
    result.columnsWithoutPose = 0;
    std::optional<PoseFault> firstFault;
    bool anyUsable = false, offMap = true;
    for (size_t c = 0; c < scan.columns.size(); ++c) {
        const ScanColumn& column = scan.columns[c];
        if (column.begin == column.end) continue;
        std::optional<PoseFault> fault = column.fault;
        if (column.sensor) {
            const Viewpoint viewpoint = viewpointOf(*column.sensor);
            fault = faultOf(viewpoint, config);
            if (!fault) viewpoints[c] = viewpoint;
            // One column with walls around it is enough; mostly, the first has.
            if (!fault && offMap) {
                offMap = !map.hasWallWithin(viewpoint.position, config.maxRange);
            }
        }
        if (fault) ++result.columnsWithoutPose;
        if (fault && !firstFault) firstFault = fault;
        anyUsable = anyUsable || !fault;
    }
    result.notReduced.reset();
    if (!anyUsable) result.notReduced = firstFault;  // none in a scan without points
    if (anyUsable && offMap) result.notReduced = PoseFault::OffMap;
}

void Reducer::Workspace::measureSegments(const ReductionConfig& config) {
    const double maxMountingSlope = std::tan(config.groundInterval.maxMountingTilt);
    result.matches.assign(result.segments.size(), SegmentMatch());  // Kept, NoPose
    for (size_t s = 0; s < result.segments.size(); ++s) {
        result.matches[s].measured = groundInterval(result.segments[s], levelled, maxMountingSlope);
    }
}

void Reducer::Workspace::matchByRays(const LineMap& map, const ReductionConfig& config) {
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const VerticalSegment& segment = result.segments[s];
        SegmentMatch& match = result.matches[s];
        const auto& viewpoint = viewpoints[segment.column];
        if (viewpoint)
            match = matchByRay(segment, match.measured, *viewpoint, map, config.matching);
    }
}

/// How the scan's poses are to be corrected; none if what it shows does not fit them.
std::optional<PoseCorrection> Reducer::Workspace::correct(const OrganizedScan& scan,
                                                          const LineMap& map,
                                                          const ReductionConfig& config) {
    placesOf(scan, places);
    findSights(scan, levelled, places, result.segments, sights);
    std::erase_if(sights, [&](const WallSight& sight) {
        return !viewpoints[result.segments[sight.segment].column];
    });
    if (sights.empty()) return std::nullopt;
    const auto& first = *scan.columns[result.segments[sights.front().segment].column].sensor;
    const mrpt::math::TPoint2D pivot(first.sensorInMap.x(), first.sensorInMap.y());
    // Off the map, the gates find nothing and say so.
    if (config.matching.method == MatchingMethod::Probabilistic || result.notReduced) {
        return uncorrected(pivot, first.groundCovariance, config.alignment);
    }
    result.alignment =
        align(sights, map, pivot, first.groundCovariance, config.alignment, alignment);
    if (result.alignment->fits(config.alignment.minFittedShare))
        return result.alignment->correction;
    result.notReduced = PoseFault::DoesNotFit;
    return std::nullopt;
}

void Reducer::Workspace::matchByGates(const PoseCorrection& correction, const LineMap& map,
                                      const ReductionConfig& config) {
    const Turn turn(correction);
    for (const WallSight& sight : sights) {
        SegmentMatch& match = result.matches[sight.segment];
        match = matchByGate(sight, match.measured, correction, turn, map, config);
    }
}

void Reducer::Workspace::labelPoints(size_t points) {
    result.labels.assign(points, PointLabel::NotOnVerticalSegment);
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const PointLabel label = result.matches[s].mapped() ? PointLabel::Mapped
                                 : result.matches[s].verdict == Verdict::RemovedAsOrphan
                                     ? PointLabel::Orphan
                                     : PointLabel::Kept;
        std::fill(result.labels.begin() + result.segments[s].begin,
                  result.labels.begin() + result.segments[s].end, label);
    }
}

Reducer::Reducer(const LineMap& map, const ReductionConfig& config)
    : map_(map), config_(config), work_(std::make_unique<Workspace>()) {
    config_.validate();
}

Reducer::~Reducer() = default;
Reducer::Reducer(Reducer&&) noexcept = default;

const ReductionResult& Reducer::reduce(const OrganizedScan& scan) {
    auto& [levelled, splitting, viewpoints, byColumn, extension, places, sights, alignment,
           looseReturns, result] = *work_;
    result.alignment.reset();
    level(scan, levelled);
    findVerticalSegments(scan, levelled, config_.vertical, splitting,
                         result.segments);                // section 3
    work_->findViewpoints(scan, map_, config_.matching);  // 3.2
    work_->measureSegments(config_);                      // eqs. 3-5
    if (config_.matching.method == MatchingMethod::Paper) {
        reduceByRays(scan);
    } else {
        reduceByGates(scan);
    }
    return result;
}

/// As the paper does it.
void Reducer::reduceByRays(const OrganizedScan& scan) {
    auto& [levelled, splitting, viewpoints, byColumn, extension, places, sights, alignment,
           looseReturns, result] = *work_;
    const ColumnRing ring(scan);
    work_->matchByRays(map_, config_);  // eqs. 1, 6, 7
    byColumn.build(result.segments, viewpoints);
    if (config_.extension.enabled) {
        extendAlongWalls(ring, result.segments, byColumn, viewpoints, map_, config_,
                         extension,  // 3.3
                         result.matches);
    }
    if (config_.orphan.remove) {
        removeOrphans(ring, result.segments, byColumn, config_.orphan, result.matches);  // 3.4
    }
    work_->labelPoints(scan.points.size());
}

/// With the pose conditioned on the scan, and all that is uncertain in one gate.
void Reducer::reduceByGates(const OrganizedScan& scan) {
    ReductionResult& result = work_->result;
    const auto correction = work_->correct(scan, map_, config_);
    if (correction) work_->matchByGates(*correction, map_, config_);
    if (correction && config_.orphan.remove) {
        work_->byColumn.build(result.segments, work_->viewpoints);
        removeOrphans(ColumnRing(scan), result.segments, work_->byColumn, config_.orphan,
                      result.matches);
    }
    work_->labelPoints(scan.points.size());
    if (!correction) return;
    const ReturnOffsets offsets(scan, work_->levelled, work_->places, *correction, map_,
                                config_.alignment);
    labelLooseReturns(offsets, result.segments, result.matches, work_->looseReturns, result.labels);
    keepRunsOffTheWall(offsets, result.segments, result.matches, result.labels);
    keepFloorAtTheFoot(offsets, result.segments, result.matches, result.labels);
}

}  // namespace offmap::core
