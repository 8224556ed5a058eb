// SPDX-License-Identifier: BSD-3-Clause
#include "FileBytes.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace offmap::maps {

std::string bytesOf(const std::filesystem::path& file, size_t most) {
    const auto fail = [&](int error) {
        throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(),
                                             std::generic_category().message(error)));
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                             &std::fclose);
    if (!in) fail(errno);
    std::string bytes;
    std::array<char, 65536> part{};
    while (const size_t count = std::fread(part.data(), 1, part.size(), in.get())) {
        bytes.append(part.data(), count);
        if (bytes.size() > most) {
            throw std::runtime_error(fmt::format("{}: holds more than {:g} MB; is it a map?",
                                                 file.string(), static_cast<double>(most) / 1e6));
        }
    }
    if (std::ferror(in.get()) != 0) fail(errno);  // a folder, too
    return bytes;
}

}  // namespace offmap::maps
