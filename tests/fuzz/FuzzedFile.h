// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/maps/Drawing.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace offmap::test {

/// A file that readers are given, one for each process.
class FuzzedFile {
 public:
    explicit FuzzedFile(const std::string& name) {
        const bool inMemory = std::filesystem::exists("/dev/shm");
        std::string folder = inMemory ? "/dev/shm/offmap.XXXXXX" : "/tmp/offmap.XXXXXX";
        if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder");
        folder_ = folder;
        path_ = folder_ / name;
    }
    ~FuzzedFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    FuzzedFile(const FuzzedFile&) = delete;
    FuzzedFile& operator=(const FuzzedFile&) = delete;

    void write(const uint8_t* bytes, size_t size) const {
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    }
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path folder_, path_;
};

/// Calls read(): it may refuse what it is given, but what it gives is to be a map.
template <class Read>
void expectMapOrMessage(const Read& read) {
    maps::Drawing drawing;
    try {
        drawing = read();
    } catch (const std::runtime_error&) {
        return;
    }
    const core::LineMap map(std::move(drawing.walls));
    static_cast<void>(map.castRay({0, 0}, {1, 0}, 100, 1));
}

}  // namespace offmap::test
