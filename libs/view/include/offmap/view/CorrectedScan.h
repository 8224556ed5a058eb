// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/poses/CPose3D.h>

namespace offmap::view {

/// Where the reduction found a column's sensor to have stood; as stated, where no pose was
/// corrected or none fitted. \pre the column has a pose
mrpt::poses::CPose3D foundSensor(const core::ScanColumn& column,
                                 const core::ReductionResult& result);

/// The scan with its columns where the reduction found them to have been taken from, so that what
/// it matched to a wall is seen there.
core::OrganizedScan correctedScan(const core::OrganizedScan& scan,
                                  const core::ReductionResult& result);

}  // namespace offmap::view
