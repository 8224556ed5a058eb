// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

namespace offmap::rawlog {

/// CObservationRotatingScan: one column a firing (RotatingGeometry). A slot is a cell of the range
/// image, row by row, and then of each other layer in the order of their names; one that is taken
/// out becomes range 0. Of a second return that differs from the first a column is made of its own,
/// behind those of the first returns. \pre unsupportedRotatingScan() knows of no reason
class RotatingScan final : public ScanClass {
 public:
    using ScanClass::withOnly;

    size_t slotCount(const mrpt::obs::CObservation& obs) const override;
    std::vector<float> intensities(const mrpt::obs::CObservation& obs) const override;
    TurnScan organize(const Turn& turn, const PoseSource& poses,
                      const SensorConfig& config) const override;
    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                          Leftovers leftovers) const override;
    /// CPointsMapXYZI, intensities from 0 to 1 (those of other layers: 0), if the scan has an
    /// intensity image; else CSimplePointsMap.
    mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs, SlotMask keep,
                                              const SensorConfig& config) const override;
};

}  // namespace offmap::rawlog
