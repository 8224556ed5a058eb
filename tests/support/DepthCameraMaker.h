// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <memory>

namespace offmap::test {

using DepthImage = mrpt::obs::CObservation3DRangeScan;

/// A depth camera of 160 x 120 pixels and 60 x 47 degrees, in steps of 1 mm, that sees nothing.
inline std::shared_ptr<DepthImage> emptyDepthImage(int columns = 160, int rows = 120) {
    auto obs = std::make_shared<DepthImage>();
    obs->hasRangeImage = true;
    obs->rangeImage.setSize(rows, columns);
    obs->rangeImage.fill(0);
    obs->cameraParams.ncols = static_cast<uint32_t>(columns);
    obs->cameraParams.nrows = static_cast<uint32_t>(rows);
    const double focal = 0.5 * columns / std::tan(mrpt::DEG2RAD(30.0));
    obs->cameraParams.setIntrinsicParamsFromValues(focal, focal, 0.5 * (columns - 1),
                                                   0.5 * (rows - 1));
    return obs;
}

/// Fills the range image with what `depth` tells of each pixel.
/// \param depth of a direction (1, y, z) in the camera's frame: distance forwards [m], 0 for none
template <class Depth>
void fillDepths(DepthImage& obs, Depth&& depth) {
    const auto& camera = obs.cameraParams;
    for (int row = 0; row < obs.rangeImage.rows(); ++row) {
        for (int column = 0; column < obs.rangeImage.cols(); ++column) {
            const mrpt::math::TVector3D direction{1, (camera.cx() - column) / camera.fx(),
                                                  (camera.cy() - row) / camera.fy()};
            const double metres =
                obs.range_is_depth ? depth(direction) : depth(direction) * direction.norm();
            obs.rangeImage(row, column) =
                static_cast<uint16_t>(std::lround(metres / static_cast<double>(obs.rangeUnits)));
        }
    }
}

/// Stores the points of the range image as MRPT does: those of the returns, with their pixels, or
/// one per pixel.
inline void storePoints(DepthImage& obs, bool organized = false) {
    mrpt::obs::T3DPointsProjectionParams parameters;
    parameters.takeIntoAccountSensorPoseOnRobot = false;
    parameters.MAKE_ORGANIZED = organized;
    obs.unprojectInto(obs, parameters);
}

}  // namespace offmap::test
