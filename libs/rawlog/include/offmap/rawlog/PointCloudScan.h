// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

namespace offmap::rawlog {

/// CObservationPointCloud: columns by azimuth in the sensor's frame (findCloudColumns). A slot is a
/// point; one that is taken out leaves the cloud. The cloud is assumed to be movement-compensated:
/// all of its points are placed by the pose at the observation's time.
class PointCloudScan final : public ScanClass {
 public:
    using ScanClass::withOnly;

    /// Looks where MRPT's programs put such files: in <name>_Images and Images beside the rawlog,
    /// and beside it.
    bool loadExternal(mrpt::obs::CObservation& obs,
                      const std::filesystem::path& rawlogFile) const override;
    /// \throw std::logic_error if the cloud is stored externally: loadExternal() comes first.
    size_t slotCount(const mrpt::obs::CObservation& obs) const override;
    std::vector<float> intensities(const mrpt::obs::CObservation& obs) const override;
    TurnScan organize(const Turn& turn, const PoseSource& poses,
                      const SensorConfig& config) const override;
    /// Same class of map, all of its channels and options.
    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                          Leftovers leftovers) const override;
    mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs, SlotMask keep,
                                              const SensorConfig& config) const override;
};

}  // namespace offmap::rawlog
