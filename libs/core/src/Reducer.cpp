// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnFindings.h"

#include <offmap/core/HorizontalExtension.h>
#include <offmap/core/OrphanRemoval.h>
#include <offmap/core/PointLevel.h>
#include <offmap/core/Reducer.h>
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/WallGate.h>

#include <algorithm>

namespace offmap::core {

struct Reducer::Workspace {
    Workspace(const LineMap& map, const ReductionConfig& config) : findings(map, config) {}

    ColumnFindings findings;
    SegmentsByColumn byColumn;
    ExtensionScratch extension;
    AlignmentScratch alignment;
    LooseReturnsScratch looseReturns;
    ReductionResult result;

    std::optional<PoseCorrection> correct(const OrganizedScan& scan, const LineMap& map,
                                          const ReductionConfig& config);
    void matchByGates(const PoseCorrection& correction, const LineMap& map,
                      const ReductionConfig& config);
    void labelPoints(size_t points);
};

/// How the scan's poses are to be corrected; none if what it shows does not fit them.
std::optional<PoseCorrection> Reducer::Workspace::correct(const OrganizedScan& scan,
                                                          const LineMap& map,
                                                          const ReductionConfig& config) {
    const auto& sights = findings.sights();
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
    for (const WallSight& sight : findings.sights()) {
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
    : map_(map), config_(std::make_unique<ReductionConfig>(config)) {
    config_->validate();
    work_ = std::make_unique<Workspace>(map_, *config_);
    begin();
}

Reducer::~Reducer() = default;
Reducer::Reducer(Reducer&&) noexcept = default;

const ReductionResult& Reducer::reduce(const OrganizedScan& scan) {
    begin();
    return finish(scan);
}

void Reducer::begin() {
    ReductionResult& result = work_->result;
    work_->findings.begin();
    result.segments.clear();
    result.matches.clear();
    result.columnsWithoutPose = 0;
    result.notReduced.reset();
    result.alignment.reset();
}

ColumnVerdicts Reducer::add(const OrganizedScan& scan) {
    ReductionResult& result = work_->result;
    const size_t known = result.segments.size();
    work_->findings.add(scan, result);
    return {std::span(result.segments).subspan(known), std::span(result.matches).subspan(known)};
}

const ReductionResult& Reducer::finish(const OrganizedScan& scan) {
    add(scan);
    work_->result.notReduced = work_->findings.notReduced();
    if (config_->matching.method == MatchingMethod::Paper) {
        finishByRays(scan);
    } else {
        finishByGates(scan);
    }
    return work_->result;
}

/// As the paper does it.
void Reducer::finishByRays(const OrganizedScan& scan) {
    const auto& viewpoints = work_->findings.viewpoints();
    SegmentsByColumn& byColumn = work_->byColumn;
    ReductionResult& result = work_->result;
    const ColumnRing ring(scan);
    byColumn.build(result.segments, viewpoints);
    if (config_->extension.enabled) {
        extendAlongWalls(ring, result.segments, byColumn, viewpoints, map_, *config_,
                         work_->extension, result.matches);  // 3.3
    }
    if (config_->orphan.remove) {
        removeOrphans(ring, result.segments, byColumn, config_->orphan, result.matches);  // 3.4
    }
    work_->labelPoints(scan.points.size());
}

/// With the pose conditioned on the scan, and all that is uncertain in one gate.
void Reducer::finishByGates(const OrganizedScan& scan) {
    const ColumnFindings& findings = work_->findings;
    ReductionResult& result = work_->result;
    const auto correction = work_->correct(scan, map_, *config_);
    if (correction) work_->matchByGates(*correction, map_, *config_);
    if (correction && config_->orphan.remove) {
        work_->byColumn.build(result.segments, findings.viewpoints());
        removeOrphans(ColumnRing(scan), result.segments, work_->byColumn, config_->orphan,
                      result.matches);
    }
    work_->labelPoints(scan.points.size());
    if (!correction) return;
    const ReturnOffsets offsets(scan, findings.levelled(), findings.places(), *correction, map_,
                                config_->alignment);
    labelLooseReturns(offsets, result.segments, result.matches, work_->looseReturns, result.labels);
    keepRunsOffTheWall(offsets, result.segments, result.matches, result.labels);
    keepFloorAtTheFoot(offsets, result.segments, result.matches, result.labels);
}

}  // namespace offmap::core
