// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <vector>

namespace offmap::rawlog {

/// How bright the return in each slot of a turn is, as ScanClass::intensities() tells it; empty if
/// no observation tells any.
std::vector<float> slotIntensitiesOf(const Turn& turn, const ScanClass& scanClass);

/// The same for each point of the turn's scan, to be looked at: of a depth camera, how bright its
/// picture is there.
std::vector<float> pointIntensitiesOf(const Turn& turn, const ScanClass& scanClass,
                                      const core::OrganizedScan& scan);

}  // namespace offmap::rawlog
