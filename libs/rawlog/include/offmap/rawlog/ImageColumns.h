// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/RangeImage.h>

#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// Pixels that stand above each other in the world.
struct ImageColumn {
    double azimuth = 0;            ///< [rad] CCW from the vehicle's x axis
    std::vector<uint32_t> pixels;  ///< row-major; bottom to top where they are a line of the image
};

/// The columns of a camera's image in the order of rotation: the image's columns; its rows if the
/// camera is turned on its side. If it is inclined so much that neither keeps its azimuth, pixels
/// are gathered by azimuth.
/// \param width [rad] of a column gathered by azimuth; 0: about one pixel
std::vector<ImageColumn> findImageColumns(const RangeImage& image,
                                          const mrpt::poses::CPose3D& cameraInVehicle,
                                          double width = 0);

}  // namespace offmap::rawlog
