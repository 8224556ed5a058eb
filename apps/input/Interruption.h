// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <csignal>

namespace offmap::app {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the program but are remembered. One at a
/// time.
class Interruption {
 public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool came() const;

 private:
    static constexpr std::array<int, 3> watched{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace offmap::app
