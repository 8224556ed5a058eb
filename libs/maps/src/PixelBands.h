// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <gdal_priv.h>
#include <optional>
#include <string>
#include <vector>

namespace offmap::maps {

/// The pixels of a picture, a row at a time.
class PixelBands {
 public:
    /// \param white the number that stands for it; none: the largest that a pixel can hold
    /// \param name stands for the picture in messages
    /// \throw std::runtime_error if its pixels are no whole numbers of 8 or 16 bits
    PixelBands(GDALDataset& picture, std::optional<double> white, const std::string& name);

    /// Of the row that the next two are about. \return whether it could be read
    bool readRow(int row);
    double brightness(int x) const;  ///< 0 black ... 1 white, the mean of the colours
    bool isOpaque(int x) const;      ///< by half at least

 private:
    struct Band {
        GDALRasterBand* band;
        double white;
        std::optional<double> transparent;  ///< the number that stands for no pixel
        std::vector<uint16_t> row;
    };
    struct Ink {
        double brightness;
        bool isOpaque;
    };

    std::vector<Band> colours_;
    std::optional<Band> opacity_;
    std::vector<Ink> palette_;  ///< of the only colour; empty: it has none
    int width_;
};

}  // namespace offmap::maps
