// SPDX-License-Identifier: BSD-3-Clause
#include "PixelBands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace offmap::maps {

namespace {

/// The largest number that a pixel can hold.
double whiteOf(GDALRasterBand& band, const std::string& name) {
    const GDALDataType type = band.GetRasterDataType();
    if (type != GDT_Byte && type != GDT_UInt16) {
        throw std::runtime_error(
            fmt::format("{}: pixels of type {}; save the picture with 8 or 16 bits a colour", name,
                        GDALGetDataTypeName(type)));
    }
    const char* bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    const int most = type == GDT_Byte ? 8 : 16;
    const int used = bits == nullptr ? most : std::clamp(std::atoi(bits), 1, most);
    return (1 << used) - 1;
}

}  // namespace

PixelBands::PixelBands(GDALDataset& picture, std::optional<double> white, const std::string& name)
    : width_(picture.GetRasterXSize()) {
    for (GDALRasterBand* band : picture.GetBands()) {
        Band one{band, white.value_or(whiteOf(*band, name)), std::nullopt,
                 std::vector<uint16_t>(static_cast<size_t>(width_))};
        int hasNone = FALSE;
        const double none = band->GetNoDataValue(&hasNone);
        if (hasNone != FALSE) one.transparent = none;
        if (band->GetColorInterpretation() == GCI_AlphaBand) {
            opacity_ = std::move(one);
        } else {
            colours_.push_back(std::move(one));
        }
    }
    if (colours_.empty()) throw std::runtime_error(name + ": the picture has no colour at all");
    const GDALColorTable* table = colours_.front().band->GetColorTable();
    for (int i = 0; table != nullptr && i < table->GetColorEntryCount(); ++i) {
        const GDALColorEntry& ink = *table->GetColorEntry(i);
        constexpr int half = 128;
        palette_.push_back({(ink.c1 + ink.c2 + ink.c3) / (3 * 255.0), ink.c4 >= half});
    }
}

bool PixelBands::readRow(int row) {
    const auto read = [&](Band& band) {
        return band.band->RasterIO(GF_Read, 0, row, width_, 1, band.row.data(), width_, 1,
                                   GDT_UInt16, 0, 0, nullptr) == CE_None;
    };
    return std::ranges::all_of(colours_, read) && (!opacity_ || read(*opacity_));
}

double PixelBands::brightness(int x) const {
    const auto at = static_cast<size_t>(x);
    if (!palette_.empty()) {
        const uint16_t ink = colours_.front().row[at];
        return ink < palette_.size() ? palette_[ink].brightness : 0;
    }
    double sum = 0;
    for (const Band& band : colours_) sum += std::min(band.row[at] / band.white, 1.0);
    return sum / static_cast<double>(colours_.size());
}

bool PixelBands::isOpaque(int x) const {
    const auto at = static_cast<size_t>(x);
    if (opacity_ && 2 * opacity_->row[at] < opacity_->white) return false;
    const uint16_t ink = colours_.front().row[at];
    if (!palette_.empty() && (ink >= palette_.size() || !palette_[ink].isOpaque)) return false;
    return !std::ranges::all_of(
        colours_, [at](const Band& band) { return band.transparent == band.row[at]; });
}

}  // namespace offmap::maps
