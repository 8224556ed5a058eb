// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapFile.h>
#include <offmap/rawlog/Config.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

namespace offmap::window {

/// The reading was stopped from outside.
class Stopped : public std::runtime_error {
 public:
    Stopped() : std::runtime_error("stopped") {}
};

/// Reads files with this program in a process of its own: what damaged files do to their
/// readers happens there, and a window, whose threads hold locks, cannot fork.
class FileReader {
 public:
    /// \param arguments of the command line, which tell how maps are read
    /// \param program offmap-view, if not this very one
    explicit FileReader(std::vector<std::string> arguments,
                        std::filesystem::path program = "/proc/self/exe")
        : arguments_(std::move(arguments)), program_(std::move(program)) {}

    /// All \throw std::runtime_error with a message for the user; Stopped
    maps::MapOfFile readMap(const std::filesystem::path& map, const rawlog::Config& config,
                            const std::stop_token& stop) const;
    void checkLog(const std::filesystem::path& log, const rawlog::Config& config,
                  const std::stop_token& stop) const;

    /// Whether the program was started as such a process.
    static bool isWanted(int argc, char** argv);
    /// What it then does. \return its exit code
    static int run(int argc, char** argv);

 private:
    std::vector<uint8_t> ask(const std::string& task, const std::filesystem::path& file,
                             const rawlog::Config& config, const std::stop_token& stop) const;

    std::vector<std::string> arguments_;
    std::filesystem::path program_;
};

}  // namespace offmap::window
