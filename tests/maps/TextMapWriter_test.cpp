// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/TextMapWriter.h>

#include <gtest/gtest.h>

namespace offmap::maps {

TEST(TextMapWriter, isReadAsTheSameWalls) {
    const std::vector<core::Wall> walls{
        {.line = {{0, -1.25}, {1234.5, 2}}, .sigma = 0.01},
        {.line = {{-3.0001, 0}, {0, 7}}, .sigma = 0, .height = {0, 1.1}}};
    const auto read = parseTextMap(textMapOf(walls), "map", 0.5);
    ASSERT_EQ(read.size(), walls.size());
    for (size_t i = 0; i < walls.size(); ++i) {
        EXPECT_EQ(read[i].line.point1, walls[i].line.point1);
        EXPECT_EQ(read[i].line.point2, walls[i].line.point2);
        EXPECT_EQ(read[i].sigma, walls[i].sigma);
        EXPECT_EQ(read[i].height.min(), walls[i].height.min());
        EXPECT_EQ(read[i].height.max(), walls[i].height.max());
    }
}

TEST(TextMapWriter, bentWallIsReadAsOneOfTheSameCourse) {
    const core::Wall left{.line = {{2, -1}, {3.5, 0.5}}, .sigma = 0.02, .curvature = 0.5};
    core::Wall right = left;
    right.curvature = -0.5;
    for (const core::Wall& wall : {left, right}) {
        const auto read = parseTextMap(textMapOf(std::vector{wall}), "map", 0.5);
        double length = 0;
        for (const core::Wall& part : read) {
            length += core::lengthOf(part);
            for (const double share : {0.0, 0.5, 1.0}) {
                // centre and radius are written to 0.05 mm each, in x and in y
                EXPECT_LT(core::distanceTo(wall, core::placeAt(part, share)), 0.15e-3);
            }
        }
        EXPECT_NEAR(length, core::lengthOf(wall), 0.3e-3);
    }
}

TEST(TextMapWriter, roundsToATenthOfAMillimetre) {
    const std::vector<core::Wall> walls{{.line = {{1.0 / 3, 0}, {1, 2.0 / 3}}, .sigma = 0.02}};
    EXPECT_EQ(textMapOf(walls),
              "# x1 y1 x2 y2 sigma [z_min z_max], in metres\n"
              "0.3333 0.0000  1.0000 0.6667  0.0200\n");
}

}  // namespace offmap::maps
