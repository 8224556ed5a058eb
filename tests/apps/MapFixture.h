// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFixture.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapFile.h>

namespace offmap::test {

/// A map with all that text knows of: an arc, walls of their own sigma and height.
class MapFixture : public ReduceFixture {
 protected:
    MapFixture() {
        writeFile(map_,
                  "# a hall, 10 m by 6 m, with a round end, a counter, and a pillar\n"
                  "0 0 10 0\n"
                  "arc 10 3 3 -90 90\n"
                  "10 6 0 6\n"
                  "0 6 0 0 0.1\n"
                  "2 2 2 4 0.02 0 1.1\n"
                  "4 2 4.3 2\n");
    }

    static maps::MapOfFile wallsIn(const Path& file) { return maps::readMap(file, {}); }

    RunResult map(const std::string& what, const Arguments& more = {}) const {
        Arguments all{"map", what, map_};
        all.insert(all.end(), more.begin(), more.end());
        return runOffmap(all);
    }

    template <class Matcher>
    void expectMapRefused(const std::string& what, const Arguments& more, int exitCode,
                          const Matcher& message) const {
        Arguments all{"map", what, map_};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, exitCode, message);
    }
};

/// [m] How far any place on these walls is from the nearest of the others.
inline double farthestFrom(const std::vector<core::Wall>& walls,
                           const std::vector<core::Wall>& others) {
    double farthest = 0;
    for (const core::Wall& wall : walls) {
        for (int i = 0; i <= 20; ++i) {
            const auto place = core::placeAt(wall, i / 20.0);
            double nearest = 1e9;
            for (const core::Wall& other : others) {
                nearest = std::min(nearest, core::distanceTo(other, place));
            }
            farthest = std::max(farthest, nearest);
        }
    }
    return farthest;
}

}  // namespace offmap::test
