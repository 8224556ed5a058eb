// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/OrphanRemoval.h>

namespace offmap::core {

namespace {

/// Whether one segment is company for another: kept by the matching and near. An orphan that was
/// removed before still counts, so that order does not matter; so does a segment whose column has
/// no pose, as where it stands is not known.
bool isCompany(uint32_t other, uint32_t s, const SegmentsByColumn& byColumn,
               const OrphanConfig& config, std::span<const SegmentMatch> matches) {
    if (other == s || matches[other].mapped()) return false;
    if (matches[other].reason == KeepReason::NoPose) return true;
    return (byColumn.centreInMap(other) - byColumn.centreInMap(s)).norm() <= config.maxDistance;
}

}  // namespace

void removeOrphans(const ColumnRing& ring, std::span<const VerticalSegment> segments,
                   const SegmentsByColumn& byColumn, const OrphanConfig& config,
                   std::span<SegmentMatch> matches) {
    const auto hasCompanyIn = [&](uint32_t s, uint32_t column) {
        const auto [begin, end] = byColumn.of(column);
        for (uint32_t other = begin; other < end; ++other) {
            if (isCompany(other, s, byColumn, config, matches)) return true;
        }
        return false;
    };
    for (uint32_t s = 0; s < segments.size(); ++s) {
        if (matches[s].verdict != Verdict::Kept || matches[s].reason == KeepReason::NoPose)
            continue;
        bool company = hasCompanyIn(s, segments[s].column);
        for (const int step : {-1, +1}) {
            std::optional<uint32_t> column = segments[s].column;
            for (uint32_t n = 0; n < config.neighbourColumns && !company; ++n) {
                column = ring.neighbour(*column, step);
                if (!column || *column == segments[s].column) break;
                company = hasCompanyIn(s, *column);
            }
        }
        if (!company) {
            matches[s].verdict = Verdict::RemovedAsOrphan;
            matches[s].reason = KeepReason::None;
        }
    }
}

}  // namespace offmap::core
