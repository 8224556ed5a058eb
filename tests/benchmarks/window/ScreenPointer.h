// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace offmap::test {

/// The pointer of the screen, moved by the X server as a hand would move it, through a connection
/// of its own: any one thread may use it.
class ScreenPointer {
 public:
    /// \throw std::runtime_error if there is no screen, or one whose pointer cannot be moved
    ScreenPointer();
    ~ScreenPointer();
    ScreenPointer(const ScreenPointer&) = delete;
    ScreenPointer& operator=(const ScreenPointer&) = delete;

    /// [px] from the upper left corner of the screen
    void moveTo(int x, int y);
    /// The left button.
    void press();
    void release();

 private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace offmap::test
