// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <optional>
#include <string>

namespace offmap::rawlog {

/// The class that reduces an observation; nullptr if there is none. Of 2D scans only vertical fans
/// have one; whether their label is a sweep, SweepDetector tells. \param config of the
/// observation's sensor: it may tell what the observation does not
const ScanClass* scanClassOf(const mrpt::obs::CObservation& obs, const SensorConfig& config);

/// For a 3D observation without a class: what it is that is not supported. None for a supported
/// one, and for what is no 3D observation.
std::optional<std::string> unsupportedReason(const mrpt::obs::CObservation& obs,
                                             const SensorConfig& config);

}  // namespace offmap::rawlog
