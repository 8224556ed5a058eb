// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace offmap::test {

/// Square houses of four walls each in a square grid.
struct Town {
    static constexpr double pitch = 15, house = 10;  // [m]

    /// About that many walls. \param freePlaces of the grid, from its middle outwards to each side,
    /// that hold no house
    explicit Town(int64_t about, int freePlaces = -1) {
        const auto side = static_cast<int>(std::lround(std::sqrt(double(about) / 4)));
        const double low = -pitch * (side / 2);

        for (int i = 0; i < side * side; ++i) {
            const int column = i % side - side / 2, row = i / side - side / 2;
            if (std::abs(column) <= freePlaces && std::abs(row) <= freePlaces) continue;
            addHouse(low + pitch * (i % side), low + pitch * (i / side));
        }
    }

    std::vector<core::Wall> walls;

 private:
    void addHouse(double x, double y) {
        using mrpt::math::TPoint2D;
        const TPoint2D a(x, y), b(x + house, y), c(x + house, y + house), d(x, y + house);
        for (const auto& [from, to] :
             {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)}) {
            walls.push_back({{from, to}});
        }
    }
};

}  // namespace offmap::test
