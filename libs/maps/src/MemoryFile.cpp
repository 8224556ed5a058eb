// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryFile.h"

#include <fmt/format.h>

#include <atomic>
#include <cpl_vsi.h>
#include <cstdint>
#include <stdexcept>

namespace offmap::maps {

MemoryFile::MemoryFile(std::string_view bytes) {
    static std::atomic<uint64_t> count = 0;
    name_ = fmt::format("/vsimem/offmap_{}", count++);
    VSILFILE* file = VSIFOpenL(name(), "wb");
    if (file == nullptr || VSIFWriteL(bytes.data(), 1, bytes.size(), file) != bytes.size() ||
        VSIFCloseL(file) != 0) {
        throw std::runtime_error("GDAL cannot write a file in memory");
    }
}

MemoryFile::~MemoryFile() { VSIUnlink(name()); }

std::string MemoryFile::bytes() const {
    vsi_l_offset size = 0;
    const GByte* begin = VSIGetMemFileBuffer(name(), &size, FALSE);
    return begin == nullptr ? "" : std::string(begin, begin + size);
}

}  // namespace offmap::maps
