// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PlanView.h"

#include <cstdint>
#include <vector>

namespace offmap::window {

/// Which pixels of a pane are covered: a drawing of one colour without smooth edges, which costs
/// little however much is drawn. What lies outside is left out.
class PixelMask {
 public:
    /// \param width, height [px] at least 1
    PixelMask(int width, int height);

    /// A square. \param size [px]
    void dot(const Pixel& place, int size);
    /// As wide as a pixel. \pre both ends lie within the pane or on its edge
    void line(const Pixel& from, const Pixel& to);

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return !any_; }
    /// Row by row, 0 or 255 each.
    const std::vector<uint8_t>& covered() const { return covered_; }

 private:
    void cover(int x, int y);

    int width_, height_;
    bool any_ = false;
    std::vector<uint8_t> covered_;
};

}  // namespace offmap::window
