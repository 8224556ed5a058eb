// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/view/Palette.h>
#include <offmap/view/PlacedReturns.h>

#include <mrpt/opengl/CSetOfObjects.h>

#include <cstdint>
#include <vector>

namespace offmap::view {

struct SceneOptions {
    Palette palette;
    float pointSize = 3.0F;      ///< [px]
    float wallLineWidth = 1.0F;  ///< [px]
    uint8_t wallOpacity = 48;    ///< [0, 255] of the walls' surfaces; 0: lines only
    bool showMapped = true;      ///< the returns that are removed, as orphans too
    bool showRest = true;        ///< those on no vertical segment that stay
    bool showWalls = true;
    bool showPoses = true;  ///< where the sensor stood
};

/// Whether returns of this label are drawn.
bool isShown(core::PointLabel label, const SceneOptions& options);

/// Per return whether it is not drawn, as pick() takes it; empty if all are.
std::vector<uint8_t> hiddenReturns(const PlacedReturns& returns, const SceneOptions& options);

/// The scene's parts by name: "returns", "walls", "sensor"; those that are shown.
mrpt::opengl::CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                                         const mrpt::math::TBoundingBox& extent,
                                         const SceneOptions& options = {});

/// The returns that are shown. The set is named "returns".
mrpt::opengl::CSetOfObjects::Ptr returnsOf(const PlacedReturns& returns,
                                           const SceneOptions& options = {});

/// The walls that come near `extent`, from its floor to its ceiling or as high as the map says, for
/// most reach from everywhere to everywhere. The set is named "walls"; it lets what is drawn before
/// it shine through.
mrpt::opengl::CSetOfObjects::Ptr wallsOf(const core::LineMap& map,
                                         const mrpt::math::TBoundingBox& extent,
                                         const SceneOptions& options = {});

/// A ball where the scanner stood in the middle of the turn, and an arrow to its front. The set is
/// named "sensor".
mrpt::opengl::CSetOfObjects::Ptr sensorOf(const PlacedReturns& returns,
                                          const mrpt::math::TBoundingBox& extent,
                                          const SceneOptions& options = {});

}  // namespace offmap::view
