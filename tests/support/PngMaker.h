// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <zlib.h>

namespace offmap::test {

/// What a PNG says of its pixels.
struct PngForm {
    uint32_t width, height;
    char bits = 8;     ///< of each number
    char colours = 0;  ///< 0: grey, 2: red green blue, 3: palette, 4: grey and opacity, 6: all four
    std::string palette{}, transparent{};  ///< contents of PLTE and tRNS; empty: none
};

inline std::string bigEndian(uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> shift & 0xffU);
    return bytes;
}

/// \param rows packed as PNG has them, the highest first
inline std::string makePng(const PngForm& form, std::string_view rows) {
    const auto chunk = [](const std::string& kind, const std::string& content) {
        const std::string both = kind + content;
        const auto sum =
            crc32(0, reinterpret_cast<const Bytef*>(both.data()), static_cast<uInt>(both.size()));
        return bigEndian(static_cast<uint32_t>(content.size())) + both +
               bigEndian(static_cast<uint32_t>(sum));
    };
    const size_t rowSize = rows.size() / form.height;
    std::string filtered;
    for (uint32_t row = 0; row < form.height; ++row) {
        filtered += '\0';  // no filter
        filtered += rows.substr(row * rowSize, rowSize);
    }
    uLongf size = compressBound(static_cast<uLong>(filtered.size()));
    std::string packed(size, '\0');
    if (compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                 reinterpret_cast<const Bytef*>(filtered.data()),
                 static_cast<uLong>(filtered.size())) != Z_OK) {
        throw std::runtime_error("compress failed");
    }
    packed.resize(size);
    const std::string end(3, '\0');  // compression, filter, no interlacing
    std::string png = "\x89PNG\r\n\x1a\n";
    png += chunk("IHDR",
                 bigEndian(form.width) + bigEndian(form.height) + form.bits + form.colours + end);
    if (!form.palette.empty()) png += chunk("PLTE", form.palette);
    if (!form.transparent.empty()) png += chunk("tRNS", form.transparent);
    return png + chunk("IDAT", packed) + chunk("IEND", "");
}

}  // namespace offmap::test
