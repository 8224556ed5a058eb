// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Camera.h>
#include <offmap/view/Colouring.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <wx/gdicmn.h>

namespace offmap::window {

enum class CameraMode : uint8_t { Top, Follow, Perspective };

/// What of the scene is drawn.
struct Shown {
    bool mapped = true;
    bool walls = true;
    bool ellipse = true;
    bool rest = true;  ///< returns that are not on a vertical segment
};

/// How the window looked when it was closed. It looks so again when it is opened.
struct ViewState {
    std::optional<wxRect> window;       ///< [px] on the screens; none: where the desktop puts it
    bool maximised = false;             ///< `window` is then what it goes back to
    std::map<std::string, int> sashes;  ///< [px] by the name of their splitter

    CameraMode cameraMode = CameraMode::Perspective;
    std::optional<view::Camera> camera;  ///< none: the whole map in view

    bool dark = true;
    double pointSize = 2.5;  ///< [px]
    view::ColourBy colourBy = view::ColourBy::Label;
    Shown shown;

    double speed = 1;    ///< times as fast as recorded; infinite: as fast as can be
    std::string folder;  ///< where a file was opened last; empty: nowhere yet

    static constexpr double minPointSize = 1, maxPointSize = 12;  ///< [px]
};

}  // namespace offmap::window
