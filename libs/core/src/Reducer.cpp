// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/HorizontalExtension.h>
#include <offmap/core/LevelledScan.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/OrphanRemoval.h>
#include <offmap/core/Reducer.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/VerticalSegments.h>

#include <algorithm>

namespace offmap::core {

struct Reducer::Workspace {
    LevelledScan levelled;
    SplitAndMergeScratch splitting;
    std::vector<std::optional<Viewpoint>> viewpoints;  // per column
    SegmentsByColumn byColumn;
    ExtensionScratch extension;
    ReductionResult result;

    void findViewpoints(const OrganizedScan& scan, const LineMap& map,
                        const MatchingConfig& config);
    void matchSegments(const LineMap& map, const ReductionConfig& config);
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

void Reducer::Workspace::matchSegments(const LineMap& map, const ReductionConfig& config) {
    result.matches.clear();
    for (const VerticalSegment& segment : result.segments) {
        const Interval measured = groundInterval(segment, levelled, config.groundInterval);
        const auto& viewpoint = viewpoints[segment.column];
        if (viewpoint) {
            result.matches.push_back(
                matchByRay(segment, measured, *viewpoint, map, config.matching));
        } else {
            SegmentMatch match;
            match.measured = measured;
            result.matches.push_back(match);  // Kept, NoPose
        }
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
    auto& [levelled, splitting, viewpoints, byColumn, extension, result] = *work_;
    const ColumnRing ring(scan);
    level(scan, levelled);
    findVerticalSegments(scan, levelled, config_.vertical, splitting,
                         result.segments);                // section 3
    work_->findViewpoints(scan, map_, config_.matching);  // 3.2
    work_->matchSegments(map_, config_);                  // eqs. 1-7
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
    return result;
}

}  // namespace offmap::core
