// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <optional>
#include <string>

namespace offmap::rawlog {

/// CObservation3DRangeScan, a depth camera. A slot is a pixel of the range image or of one of its
/// other layers (RangeImage); one that is taken out gets range 0, and the stored points of its
/// return go with it. Columns are those of the image (findImageColumns). Equal ranges in several
/// layers are one return; where a layer differs, it has columns of its own behind all others.
/// Without a range image a slot is a stored point, and columns go by azimuth.
class RangeImageScan final : public ScanClass {
 public:
    using ScanClass::withOnly;

    /// Range image and points. Images of intensity and confidence stay where they are.
    bool loadExternal(mrpt::obs::CObservation& obs,
                      const std::filesystem::path& rawlogFile) const override;
    /// \throw std::logic_error if ranges or points are stored externally: loadExternal() comes
    /// first.
    size_t slotCount(const mrpt::obs::CObservation& obs) const override;
    TurnScan organize(const Turn& turn, const PoseSource& poses,
                      const SensorConfig& config) const override;
    mrpt::obs::CObservation::Ptr withOnly(const mrpt::obs::CObservation& obs, SlotMask keep,
                                          Leftovers leftovers) const override;
    /// With colour or intensity where every pixel has its own in memory, as the observation says.
    mrpt::obs::CObservation::Ptr asPointCloud(const mrpt::obs::CObservation& obs, SlotMask keep,
                                              const SensorConfig& config) const override;
};

/// [0, 1] per slot: how bright the camera's picture is there, of colours too; empty unless every
/// pixel has its own in memory. No ScanClass::intensities(): it tells of the light in the room, not
/// of the return, and so nothing of how certain its range is.
std::vector<float> brightnessOf(const mrpt::obs::CObservation3DRangeScan& obs);

/// Why such an observation cannot be reduced. None if it can.
std::optional<std::string> unsupportedRangeImage(const mrpt::obs::CObservation3DRangeScan& obs);

}  // namespace offmap::rawlog
