// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AzimuthArcs.h"

#include <vector>

namespace offmap::rawlog {

/// Centres [rad] of the clusters that the arcs stand in, sorted; empty if they do not, or if arcs
/// are so long that there may be gaps in them that divide. \param arcs sorted by where they begin
std::vector<double> findClusters(const std::vector<AzimuthArc>& arcs);

}  // namespace offmap::rawlog
