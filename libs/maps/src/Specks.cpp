// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/Specks.h>

#include <utility>
#include <vector>

namespace offmap::maps {

namespace {

constexpr int reach = 2;  // [cells] a wall seen from afar is a row of dots

using Place = std::pair<int, int>;

/// The group that a cell belongs to. Its cells are marked as seen.
void collectGroup(const OccupancyGrid& grid, const Place& first, std::vector<bool>& seen,
                  std::vector<Place>& group) {
    group.assign(1, first);
    seen[grid.index(first.first, first.second)] = true;
    for (size_t i = 0; i < group.size(); ++i) {
        const auto [x, y] = group[i];
        for (int v = y - reach; v <= y + reach; ++v) {
            for (int u = x - reach; u <= x + reach; ++u) {
                if (grid.at(u, v) != Cell::Occupied || seen[grid.index(u, v)]) continue;
                seen[grid.index(u, v)] = true;
                group.emplace_back(u, v);
            }
        }
    }
}

}  // namespace

size_t dropSpecks(OccupancyGrid& grid, size_t leastCells) {
    std::vector<bool> seen(grid.cells.size());
    std::vector<Place> group;
    size_t specks = 0;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            if (grid.at(x, y) != Cell::Occupied || seen[grid.index(x, y)]) continue;
            collectGroup(grid, {x, y}, seen, group);
            if (group.size() >= leastCells) continue;
            ++specks;
            for (const auto& [u, v] : group) grid.cells[grid.index(u, v)] = Cell::Unknown;
        }
    }
    return specks;
}

}  // namespace offmap::maps
