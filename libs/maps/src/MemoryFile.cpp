// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryFile.h"

#include <fmt/format.h>

#include <atomic>
#include <cpl_vsi.h>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace offmap::maps {

MemoryFile::MemoryFile(std::string bytes, std::string_view extension) : content_(std::move(bytes)) {
    static std::atomic<uint64_t> count = 0;
    name_ = fmt::format("/vsimem/offmap_{}{}", count++, extension);
    if (content_.empty()) return;
    constexpr int ours = FALSE;  // GDAL reads the bytes where they are
    VSILFILE* file = VSIFileFromMemBuffer(name(), reinterpret_cast<GByte*>(content_.data()),
                                          content_.size(), ours);
    if (file == nullptr || VSIFCloseL(file) != 0) {
        throw std::runtime_error("GDAL cannot make a file in memory");
    }
}

MemoryFile::~MemoryFile() { VSIUnlink(name()); }

std::string MemoryFile::bytes() const {
    vsi_l_offset size = 0;
    const GByte* begin = VSIGetMemFileBuffer(name(), &size, FALSE);
    return begin == nullptr ? "" : std::string(begin, begin + size);
}

}  // namespace offmap::maps
