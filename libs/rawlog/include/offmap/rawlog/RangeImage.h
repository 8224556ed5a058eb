// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// The ranges of a depth camera's observation. Its slots are the pixels of the range image, row by
/// row from the top, then those of each other layer.
class RangeImage {
 public:
    /// \pre obs is in memory, has a range image and no fault (rangeImageFault); it outlives this
    explicit RangeImage(const mrpt::obs::CObservation3DRangeScan& obs);

    size_t rows() const { return rows_; }
    size_t columns() const { return columns_; }
    size_t pixels() const { return rows_ * columns_; }
    size_t layers() const { return layers_.size(); }
    size_t slots() const { return pixels() * layers_.size(); }

    /// In units of obs.rangeUnits; 0 is no return.
    uint16_t steps(size_t slot) const { return layers_[slot / pixels()][slot % pixels()]; }
    uint16_t steps(size_t layer, size_t pixel) const { return layers_[layer][pixel]; }

    /// [m] in the camera's frame: x forward, z up. The origin for no return.
    mrpt::math::TPoint3Df point(size_t layer, size_t pixel) const {
        return rays_[pixel] * (unit_ * static_cast<float>(layers_[layer][pixel]));
    }

    /// [-] Per pixel: a point in its direction, at range or depth 1.
    const std::vector<mrpt::math::TPoint3Df>& rays() const { return rays_; }

 private:
    size_t rows_, columns_;
    float unit_;                           ///< [m]
    std::vector<const uint16_t*> layers_;  ///< the pixels of each
    std::vector<mrpt::math::TPoint3Df> rays_;
};

/// Whether there is a range image, in memory or in a file of its own.
bool hasRanges(const mrpt::obs::CObservation3DRangeScan& obs);

/// What makes the range image one that nothing can be made of. None for an image that has yet to be
/// loaded, as far as can be seen.
std::optional<std::string> rangeImageFault(const mrpt::obs::CObservation3DRangeScan& obs);

}  // namespace offmap::rawlog
