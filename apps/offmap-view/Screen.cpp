// SPDX-License-Identifier: BSD-3-Clause
#include "Screen.h"

#include <X11/Xlib.h>
#include <cstdlib>
#include <stdexcept>

namespace offmap::window {

void requireScreen() {
    setenv("GDK_BACKEND", "x11", 0);
    Display* display = XOpenDisplay(nullptr);
    if (!display) {
        throw std::runtime_error(
            "there is no screen to open a window on (DISPLAY); `offmap live` and `offmap render` "
            "need none");
    }
    XCloseDisplay(display);
}

}  // namespace offmap::window
