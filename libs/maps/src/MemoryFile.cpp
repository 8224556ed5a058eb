// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryFile.h"

#include <fmt/format.h>

#include <atomic>
#include <cpl_vsi.h>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace offmap::maps {

namespace {

std::string newName(std::string_view extension) {
    static std::atomic<uint64_t> count = 0;
    return fmt::format("/vsimem/offmap_{}{}", count++, extension);
}

}  // namespace

MemoryFile::MemoryFile() : name_(newName("")) {}

MemoryFile::MemoryFile(std::string bytes, std::string_view extension)
    : content_(std::move(bytes)), name_(newName(extension)) {
    constexpr int ours = FALSE;  // GDAL reads the bytes where they are
    VSILFILE* file = content_.empty()
                         ? VSIFOpenL(name(), "wb")
                         : VSIFileFromMemBuffer(name(), reinterpret_cast<GByte*>(content_.data()),
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
