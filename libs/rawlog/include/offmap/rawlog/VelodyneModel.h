// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace offmap::rawlog {

/// How a Velodyne fires its lasers and packs their returns into blocks of 32.
struct VelodyneModel {
    std::string_view name;
    size_t lasers;
    size_t firingsPerBlock;  ///< 2: a block holds two firings of 16 lasers
    bool twoBanks;           ///< lasers 32 and up stand in blocks of their own (lower bank)
    bool tellsReturnMode;    ///< whether its packets say that they are of dual return mode
    double blockPeriod;      ///< [us] from one rotation of the head that is told to the next
    double firingPeriod;     ///< [us]
    double laserPeriod;      ///< [us] from laser to laser; 0: all at once
};

using LaserCalibrations = std::span<const mrpt::obs::VelodyneCalibration::PerLaserCalib>;

/// Why a Velodyne scan cannot be decoded; none if it can.
std::optional<std::string> unsupportedVelodyne(const mrpt::obs::CObservationVelodyneScan& obs);

/// What the packets are of. HDL-64E is known by its blocks of the lower bank, the others by what
/// their packets say. \throw std::invalid_argument saying why it cannot be decoded
const VelodyneModel& modelOf(const mrpt::obs::CObservationVelodyneScan& obs);

/// One entry per laser: what the observation says, else the model's default.
LaserCalibrations calibrationOf(const mrpt::obs::CObservationVelodyneScan& obs,
                                const VelodyneModel& model);

}  // namespace offmap::rawlog
