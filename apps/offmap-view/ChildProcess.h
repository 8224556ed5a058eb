// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace offmap::window {

struct ChildOutcome {
    int exitCode = 0;  ///< negative: the signal that it died of
    std::vector<uint8_t> output;
};

/// Runs a program and waits for its end. Stopped, it is killed.
/// \throw std::system_error if there is no process to be had
ChildOutcome runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const std::stop_token& stop);

}  // namespace offmap::window
