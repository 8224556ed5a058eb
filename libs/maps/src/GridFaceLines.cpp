// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/GridLines.h>

namespace offmap::maps {

using mrpt::math::TSegment2D;

namespace {

/// The runs of consecutive i in [0, count) for which there is a face.
template <class HasFace, class Visit>
void forEachRun(int count, const HasFace& hasFace, const Visit& visit) {
    for (int i = 0; i < count; ++i) {
        if (!hasFace(i)) continue;
        const int begin = i;
        while (i < count && hasFace(i)) ++i;
        visit(begin, i);
    }
}

}  // namespace

std::vector<TSegment2D> gridFaceLines(const OccupancyGrid& grid) {
    const auto isOccupied = [&](int x, int y) { return grid.at(x, y) == Cell::Occupied; };
    std::vector<TSegment2D> lines;
    for (int y = 0; y <= grid.height; ++y) {
        forEachRun(
            grid.width, [&](int x) { return isOccupied(x, y - 1) != isOccupied(x, y); },
            [&](int begin, int end) {
                lines.push_back({{double(begin), double(y)}, {double(end), double(y)}});
            });
    }
    for (int x = 0; x <= grid.width; ++x) {
        forEachRun(
            grid.height, [&](int y) { return isOccupied(x - 1, y) != isOccupied(x, y); },
            [&](int begin, int end) {
                lines.push_back({{double(x), double(begin)}, {double(x), double(end)}});
            });
    }
    return lines;
}

}  // namespace offmap::maps
