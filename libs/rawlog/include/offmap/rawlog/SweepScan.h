// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

namespace offmap::rawlog {

/// CObservation2DRangeScan whose plane stands upright, turned about the vertical: one column an
/// observation (organizeSweep). A slot is a ray; one that is taken out becomes invalid.
class SweepScan final : public ScanClass {
 public:
    using ScanClass::withOnly;

    size_t slotCount(const mrpt::obs::CObservation& obs) const override;
    std::vector<float> intensities(const mrpt::obs::CObservation& obs) const override;
    TurnScan organize(const Turn& turn, const PoseSource& poses,
                      const SensorConfig& config) const override;
    /// Rays that were invalid before stay as they are.
    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                          Leftovers leftovers) const override;
    /// CSimplePointsMap, or CPointsMapXYZI with the intensities of the rays as they are.
    mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs, SlotMask keep,
                                              const SensorConfig& config) const override;
};

}  // namespace offmap::rawlog
