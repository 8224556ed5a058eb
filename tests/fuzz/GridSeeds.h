// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/GridTraversal.h"
#include "../support/TemporaryFolder.h"

#include <filesystem>
#include <string>

namespace offmap::test {

/// A small room with what a grid can hold.
inline maps::OccupancyGrid seedGrid() {
    return gridFromText({"           ", " ########  ", " #......#  ", " #..##..#  ", " #.......##",
                         " #..#  ..  ", " ########  "});
}

}  // namespace offmap::test
