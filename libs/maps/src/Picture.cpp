// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "FileBytes.h"
#include "GdalSession.h"
#include "MemoryFile.h"
#include "PixelBands.h"

#include <fmt/format.h>

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace offmap::maps {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw std::runtime_error(fmt::format("{}: {}", name, what));
}

/// What a PGM or PPM says before its pixels.
struct NetpbmHeader {
    uint64_t width = 0, height = 0, white = 0, begin = 0;  ///< where the pixels begin [byte]
};

NetpbmHeader netpbmHeader(std::string_view bytes, const std::string& name) {
    size_t at = 2;
    const auto number = [&]() -> uint64_t {
        constexpr std::string_view blanks = " \t\r\n\v\f";
        while (at < bytes.size() &&
               (bytes[at] == '#' || blanks.find(bytes[at]) != std::string_view::npos)) {
            if (bytes[at] == '#') at = std::min(bytes.find('\n', at), bytes.size());
            if (at < bytes.size()) ++at;
        }
        uint64_t value = 0;
        const size_t begin = at;
        constexpr size_t mostDigits = 9;
        for (; at < bytes.size() && bytes[at] >= '0' && bytes[at] <= '9'; ++at) {
            if (at - begin == mostDigits) break;
            value = 10 * value + static_cast<uint64_t>(bytes[at] - '0');
        }
        if (at == begin) refuse(name, "the header of the picture is damaged; save it again");
        return value;
    };
    NetpbmHeader header;
    header.width = number();
    header.height = number();
    header.white = number();
    header.begin = at + 1;
    return header;
}

/// GDAL takes missing pixels of such a file for black, which would be walls, and tells nobody what
/// white is. \return [brightness] of white; none of other pictures
std::optional<double> netpbmWhite(std::string_view bytes, const std::string& name) {
    if (bytes.size() < 2 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '7') return {};
    if (bytes[1] != '5' && bytes[1] != '6') {
        refuse(name, fmt::format("is a picture of kind P{}; save it as binary PGM (P5) or as PNG",
                                 bytes[1]));
    }
    const NetpbmHeader header = netpbmHeader(bytes, name);
    constexpr uint64_t whitest = 65535, widest = 255;
    if (header.white == 0 || header.white > whitest) {
        refuse(name, fmt::format("white is {}, but can be 1 to {}", header.white, whitest));
    }
    const uint64_t colours = bytes[1] == '6' ? 3 : 1, perPixel = header.white > widest ? 2 : 1;
    const uint64_t row = header.width * colours * perPixel;  // < 6e9, as numbers have 9 digits
    if (header.height > 0 &&
        (bytes.size() - std::min<size_t>(header.begin, bytes.size())) / header.height < row) {
        refuse(name, fmt::format("{} x {} pixels do not fit into {} bytes: the picture is cut off",
                                 header.width, header.height, bytes.size()));
    }
    return static_cast<double>(header.white);
}

GDALDatasetUniquePtr open(const MemoryFile& memory, const GdalSession& session,
                          const std::string& name) {
    for (const auto& enroll : {GDALRegister_PNG, GDALRegister_PNM, GDALRegister_BMP,
                               GDALRegister_JPEG, GDALRegister_GTiff}) {
        enroll();
    }
    const char* const drivers[] = {"PNG", "PNM", "BMP", "JPEG", "GTiff", nullptr};
    GDALDatasetUniquePtr picture(GDALDataset::Open(
        memory.name(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers, nullptr, nullptr));
    if (picture && picture->GetRasterCount() > 0) return picture;
    const std::string why = session.why("");
    const bool known = why.find("not recognized") == std::string::npos && !why.empty();
    refuse(name, known ? "the picture is damaged: " + why
                       : "is no picture of a kind that can be read; save it as PNG");
}

}  // namespace

PictureGrid readPicture(const std::filesystem::path& file, double resolution,
                        const CellOfBrightness& cellOf) {
    const std::string name = file.string();
    constexpr size_t mostBytes = 1'000'000'000;
    std::string bytes = bytesOf(file, mostBytes);
    if (bytes.empty()) refuse(name, "the file is empty");
    const std::optional<double> white = netpbmWhite(bytes, name);
    const MemoryFile memory(std::move(bytes));
    const GdalSession session;
    const GDALDatasetUniquePtr picture = open(memory, session, name);
    PictureGrid read;
    read.grid =
        makeGrid(static_cast<uint64_t>(picture->GetRasterXSize()),
                 static_cast<uint64_t>(picture->GetRasterYSize()), resolution, Cell::Unknown, name);
    PixelBands bands(*picture, white, name);
    for (int row = 0; row < read.grid.height; ++row) {
        if (!bands.readRow(row)) {
            refuse(name, fmt::format("row {} of the picture is damaged: {}", row,
                                     session.why("the file seems cut off")));
        }
        for (int x = 0; x < read.grid.width; ++x) {
            if (!bands.isOpaque(x)) continue;
            read.grid.cells[read.grid.index(x, read.grid.height - 1 - row)] =
                cellOf(bands.brightness(x));
        }
    }
    if (!session.failures().empty()) refuse(name, "the picture is damaged: " + session.why(""));
    read.warnings = session.warnings();
    return read;
}

}  // namespace offmap::maps
