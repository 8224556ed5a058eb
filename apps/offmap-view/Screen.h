// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace offmap::window {

/// Makes sure that there is a screen to open a window on, before the toolkit looks for it. Drawing
/// in 3D needs X11; on a Wayland desktop its XWayland serves.
/// \throw std::runtime_error if there is none
void requireScreen();

}  // namespace offmap::window
