// SPDX-License-Identifier: BSD-3-Clause
#include "ScreenPointer.h"

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <stdexcept>

namespace offmap::test {

namespace {

constexpr unsigned leftButton = 1;

}  // namespace

struct ScreenPointer::Connection {
    Connection() : display(XOpenDisplay(nullptr)) {
        if (!display) throw std::runtime_error("no screen: is DISPLAY set?");
    }
    ~Connection() { XCloseDisplay(display); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    Display* const display;
};

ScreenPointer::ScreenPointer() : connection_(std::make_unique<Connection>()) {
    int ignored = 0;
    if (!XTestQueryExtension(connection_->display, &ignored, &ignored, &ignored, &ignored)) {
        throw std::runtime_error("the screen lacks the extension XTEST");
    }
}

ScreenPointer::~ScreenPointer() = default;

void ScreenPointer::moveTo(int x, int y) {
    XTestFakeMotionEvent(connection_->display, -1, x, y, CurrentTime);
    XFlush(connection_->display);
}

void ScreenPointer::press() {
    XTestFakeButtonEvent(connection_->display, leftButton, True, CurrentTime);
    XFlush(connection_->display);
}

void ScreenPointer::release() {
    XTestFakeButtonEvent(connection_->display, leftButton, False, CurrentTime);
    XFlush(connection_->display);
}

}  // namespace offmap::test
