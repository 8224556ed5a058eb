// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/view/Palette.h>

#include <mrpt/opengl/CSetOfObjects.h>

namespace offmap::view {

/// The column with a pose nearest to the middle of the turn, from there on; null if none has one.
const core::ScanColumn* middleColumn(const core::OrganizedScan& scan);

/// Where the sensor was said to stand in the middle of the turn, and where the scan shows it to
/// have stood: an arrow along the heading and the ellipse of three standard deviations, each in
/// its colour. The set is named "poses"; it is empty for a scan without poses.
/// \param size [m] of an arrow
mrpt::opengl::CSetOfObjects::Ptr poseMarksOf(const core::OrganizedScan& scan,
                                             const core::ReductionResult& result, double size,
                                             const Palette& palette);

}  // namespace offmap::view
