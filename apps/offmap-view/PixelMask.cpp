// SPDX-License-Identifier: BSD-3-Clause
#include "PixelMask.h"

#include <algorithm>
#include <cmath>

namespace offmap::window {

PixelMask::PixelMask(int width, int height)
    : width_(std::max(width, 1)),
      height_(std::max(height, 1)),
      covered_(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0) {}

void PixelMask::cover(int x, int y) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    covered_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)] = 255;
    any_ = true;
}

void PixelMask::dot(const Pixel& place, int size) {
    const bool inside = place.x >= 0 && place.y >= 0 && place.x < width_ && place.y < height_;
    if (!inside) return;
    for (int i = 0; i < size * size; ++i) {
        cover(static_cast<int>(place.x) + i % size, static_cast<int>(place.y) + i / size);
    }
}

void PixelMask::line(const Pixel& from, const Pixel& to) {
    const double right = to.x - from.x, down = to.y - from.y;
    const double longer = std::max(std::abs(right), std::abs(down));
    // One step a pixel, along whichever axis the line runs further.
    const int steps = std::max(static_cast<int>(std::ceil(longer)), 1);
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        cover(static_cast<int>(std::floor(from.x + share * right)),
              static_cast<int>(std::floor(from.y + share * down)));
    }
}

}  // namespace offmap::window
