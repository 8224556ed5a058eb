// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

namespace offmap::rawlog {

/// CObservationVelodyneScan of a VLP-16, HDL-32E or HDL-64E. A slot is a laser return in a packet;
/// one that is taken out becomes distance 0.
class VelodyneScan final : public ScanClass {
 public:
    using ScanClass::withOnly;

    size_t slotCount(const mrpt::obs::CObservation& obs) const override;
    std::vector<float> intensities(const mrpt::obs::CObservation& obs) const override;
    TurnScan organize(const Turn& turn, const PoseSource& poses,
                      const SensorConfig& config) const override;
    std::unique_ptr<ColumnStream> columnStream(const PoseSource& poses,
                                               const SensorConfig& config) const override;
    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                          Leftovers leftovers) const override;
    /// CPointsMapXYZI, intensities from 0 to 1. Of two equal returns of a laser (dual return mode),
    /// one.
    mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs, SlotMask keep,
                                              const SensorConfig& config) const override;
};

}  // namespace offmap::rawlog
