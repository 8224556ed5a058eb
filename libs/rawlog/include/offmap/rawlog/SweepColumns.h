// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

namespace offmap::rawlog {

/// The columns of one turn of a 2D scanner, in the order of the turn. A column holds the beams on
/// the side of its azimuth, in the frame of its scan. Beams past the zenith or nadir join the
/// column on the opposite side, in its frame, if one lies within 1.5 steps; otherwise they make a
/// column of their own behind the others.
/// \param turn CObservation2DRangeScan that are vertical fans
TurnScan organizeSweep(const Turn& turn, const PoseSource& poses, const SensorConfig& config);

}  // namespace offmap::rawlog
