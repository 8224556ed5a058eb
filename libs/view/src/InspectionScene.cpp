// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/CorrectedScan.h>
#include <offmap/view/InspectionScene.h>
#include <offmap/view/PoseMarks.h>
#include <offmap/view/Scene.h>

namespace offmap::view {

namespace {

/// Viewers show the objects on a ground of their own, RawLogViewer on a medium grey.
Palette onAnyGround() {
    Palette palette;
    palette.rest = {205, 209, 215};
    return palette;
}

}  // namespace

mrpt::opengl::COpenGLScene::Ptr inspectionSceneOf(const core::OrganizedScan& scan,
                                                  const core::ReductionResult& result,
                                                  const core::LineMap& map) {
    constexpr double arrow = 0.8;  // [m]
    SceneOptions options;
    options.palette = onAnyGround();
    const PlacedReturns returns =
        placedReturns(correctedScan(scan, result), result.labels, mrpt::poses::CPose3D());
    auto scene = mrpt::opengl::COpenGLScene::Create();
    scene->insert(poseMarksOf(scan, result, arrow, options.palette));
    scene->insert(sceneOf(returns, map, extentOf(returns), options));
    return scene;
}

}  // namespace offmap::view
