// SPDX-License-Identifier: BSD-3-Clause
#include "LiveProgram.h"

#include "input/Console.h"
#include "input/Guarded.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>

namespace offmap::app {

int becomeLiveProgram(char** argv) {
    prepareStandardStreams();
    return reportingErrors([&]() -> int {
        const auto self = std::filesystem::read_symlink("/proc/self/exe");
        const auto program = self.parent_path() / "offmap-live";
        execv(program.c_str(), argv);
        throw std::runtime_error(fmt::format("cannot run {}: {}; install all of offmap's programs",
                                             program.string(), std::strerror(errno)));
    });
}

}  // namespace offmap::app
