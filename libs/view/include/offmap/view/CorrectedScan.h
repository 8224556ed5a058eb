// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

namespace offmap::view {

/// The scan with its columns where the reduction found them to have been taken from, so that what
/// it matched to a wall is seen there. As it was, where no pose was corrected or none fitted.
core::OrganizedScan correctedScan(const core::OrganizedScan& scan,
                                  const core::ReductionResult& result);

}  // namespace offmap::view
