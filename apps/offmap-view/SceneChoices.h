// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ViewState.h"

#include <offmap/view/Colouring.h>
#include <offmap/view/Scene.h>

namespace offmap::window {

/// What of a scan is drawn, and how.
struct SceneChoices {
    view::ColourBy colourBy = view::ColourBy::Label;
    double pointSize = 2.5;  ///< [px]
    Shown shown;
};

inline view::SceneOptions sceneOptionsOf(const SceneChoices& choices,
                                         const view::Palette& palette) {
    view::SceneOptions options;
    options.palette = palette;
    options.pointSize = static_cast<float>(choices.pointSize);
    options.showMapped = choices.shown.mapped;
    options.showRest = choices.shown.rest;
    options.showWalls = choices.shown.walls;
    options.showPoses = choices.shown.ellipse;
    return options;
}

}  // namespace offmap::window
