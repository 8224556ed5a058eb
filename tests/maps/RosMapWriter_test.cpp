// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/maps/RosMapWriter.h>

#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

namespace offmap::maps {
namespace {

/// Three cells wide, two high: the lower left one occupied, the upper right one unknown.
OccupancyGrid smallGrid() {
    OccupancyGrid grid = makeGrid(3, 2, 0.05, Cell::Free, "test");
    grid.cells[grid.index(0, 0)] = Cell::Occupied;
    grid.cells[grid.index(2, 1)] = Cell::Unknown;
    grid.origin = {-1.25, 2.5, 0};
    return grid;
}

TEST(RosMapWriter, pictureBeginsAtTheTop) {
    const std::string expected =
        std::string("P5\n3 2\n255\n") + "\xfe\xfe\xcd" + std::string(1, '\0') + "\xfe\xfe";
    EXPECT_EQ(rosPictureOf(smallGrid()), expected);
}

TEST(RosMapWriter, yamlTellsPlaceAndSize) {
    EXPECT_EQ(rosYamlOf(smallGrid(), "plan \"A\".pgm"),
              "image: \"plan \\\"A\\\".pgm\"\n"
              "mode: trinary\n"
              "resolution: 0.05\n"
              "origin: [-1.250000, 2.500000, 0.000000000]\n"
              "negate: 0\n"
              "occupied_thresh: 0.65\n"
              "free_thresh: 0.196\n");
}

// MRPT's own reader of ROS maps, which knows nothing of ours.
TEST(RosMapWriter, mrptReadsIt) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "plan.yaml", rosYamlOf(smallGrid(), "plan.pgm"));
    test::writeFile(folder / "plan.pgm", rosPictureOf(smallGrid()));
    const auto grid =
        mrpt::maps::COccupancyGridMap2D::FromROSMapServerYAML((folder / "plan.yaml").string());
    ASSERT_EQ(grid.getSizeX(), 3U);
    ASSERT_EQ(grid.getSizeY(), 2U);
    EXPECT_NEAR(grid.getXMin(), -1.25, 1e-6);
    EXPECT_NEAR(grid.getYMin(), 2.5, 1e-6);
    EXPECT_LT(grid.getCell(0, 0), 0.3F);
    EXPECT_GT(grid.getCell(1, 0), 0.7F);
    EXPECT_GT(grid.getCell(0, 1), 0.7F);
}

}  // namespace
}  // namespace offmap::maps
