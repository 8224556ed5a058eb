// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/opengl/COpenGLScene.h>

namespace offmap::view {

/// A scan as it was reduced, for a 3D viewer that turns and zooms by itself: returns by their
/// label, walls, and the poses. Columns without a pose stand around the map's origin.
mrpt::opengl::COpenGLScene::Ptr inspectionSceneOf(const core::OrganizedScan& scan,
                                                  const core::ReductionResult& result,
                                                  const core::LineMap& map);

}  // namespace offmap::view
