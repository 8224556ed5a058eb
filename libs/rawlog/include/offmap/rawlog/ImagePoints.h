// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/RangeImage.h>
#include <offmap/rawlog/ScanClass.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// Which returns of a range image the points are that the observation stores beside it.
struct ImagePoints {
    static constexpr uint32_t none = 0xFFFFFFFF;
    std::vector<uint32_t> slotOf;  ///< per point: the slot of its return; none if it has none
    bool organized = false;        ///< one point per pixel, the origin where there is no return
};

/// By place if there is a point per pixel, by the stored indices, or by order if there is a point
/// per return: whichever numbering puts most points within 5 % of their pixels' returns. Indices
/// alone prove nothing: MRPT fills those of logs that have none with whatever was in memory.
ImagePoints findImagePoints(const mrpt::obs::CObservation3DRangeScan& obs, const RangeImage& image);

/// Takes the points out whose returns are not kept. Of an organised cloud they become the origin.
void filterPoints(mrpt::obs::CObservation3DRangeScan& obs, const ImagePoints& points, SlotMask keep,
                  Leftovers leftovers);

/// Gives every point the column and row of its pixel; (0, 0) to one without.
void storeIndices(mrpt::obs::CObservation3DRangeScan& obs, const ImagePoints& points,
                  const RangeImage& image);

}  // namespace offmap::rawlog
