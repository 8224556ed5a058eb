// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ColumnRing.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/SegmentsByColumn.h>

#include <span>

namespace offmap::core {

/// Removes kept segments without a kept neighbour, as mixed pixels leave them behind (section 3.4).
/// A thin or distant object may be no wider than one column, which is why nothing calls this unless
/// asked to.
void removeOrphans(const ColumnRing& ring, std::span<const VerticalSegment> segments,
                   const SegmentsByColumn& byColumn, const OrphanConfig& config,
                   std::span<SegmentMatch> matches);

}  // namespace offmap::core
