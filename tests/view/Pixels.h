// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/CImage.h>
#include <mrpt/img/TColor.h>

#include <algorithm>
#include <cstdlib>

namespace offmap::view {

/// The pixels of one colour in a picture.
struct Pixels {
    int count = 0;
    double meanX = 0, meanY = 0;                                 ///< [px]
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;  ///< [px] of the outermost

    /// Counts pixels that differ by at most 6 of 255 in each channel from a colour.
    static Pixels of(const mrpt::img::CImage& image, const mrpt::img::TColor& colour) {
        const auto near = [](uint8_t a, uint8_t b) { return std::abs(int{a} - int{b}) <= 6; };
        Pixels found;
        for (int y = 0; y < static_cast<int>(image.getHeight()); ++y) {
            for (int x = 0; x < static_cast<int>(image.getWidth()); ++x) {
                const auto* bgr =
                    image.ptr<uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y));
                if (!near(bgr[0], colour.B) || !near(bgr[1], colour.G) || !near(bgr[2], colour.R))
                    continue;
                ++found.count;
                found.left = std::min(found.left, x);
                found.right = std::max(found.right, x);
                found.top = std::min(found.top, y);
                found.bottom = std::max(found.bottom, y);
                found.meanX += x;
                found.meanY += y;
            }
        }
        if (found.count > 0) {
            found.meanX /= found.count;
            found.meanY /= found.count;
        }
        return found;
    }
};

}  // namespace offmap::view
