// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/view/Palette.h>
#include <offmap/view/PlacedReturns.h>

#include <mrpt/opengl/CSetOfObjects.h>

namespace offmap::view {

struct SceneOptions {
    Palette palette;
    float pointSize = 3.0F;      ///< [px]
    float wallLineWidth = 1.0F;  ///< [px]
    uint8_t wallOpacity = 48;    ///< [0, 255] of the walls' surfaces; 0: lines only
};

/// The scene's parts by name: "returns", "walls", "sensor". Walls are drawn where they come near
/// `extent`, from its floor to its ceiling or as high as the map says, for most reach from
/// everywhere to everywhere.
mrpt::opengl::CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                                         const mrpt::math::TBoundingBox& extent,
                                         const SceneOptions& options = {});

}  // namespace offmap::view
