// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SimulationPlan.h"

#include <offmap/evaluation/TruthFile.h>
#include <offmap/rawlog/ScanClass.h>

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <vector>

namespace offmap::app {

/// A turn as it stands in the log.
struct LoggedTurn {
    std::vector<mrpt::obs::CObservation::Ptr> entries;  ///< scans and poses, by time
    std::vector<evaluation::ObservationTruth> truth;    ///< per observation of the scan
};

/// The turn that begins at a place of the plan. The same plan and place give the same turn.
LoggedTurn simulateTurn(const SimulationPlan& plan, size_t place);

/// How the observations are to be read, as far as they do not tell it themselves.
rawlog::SensorConfig sensorConfigOf(const LogSensor& sensor);

/// What the observations' returns truly are. Vertical segments are those of default parameters.
std::vector<evaluation::ObservationTruth> truthOf(const evaluation::SimulatedScan& scan,
                                                  const std::vector<EncodedObservation>& encoded,
                                                  const rawlog::SensorConfig& config,
                                                  uint64_t scanNumber);

}  // namespace offmap::app
