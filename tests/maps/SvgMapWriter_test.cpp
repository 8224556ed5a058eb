// SPDX-License-Identifier: BSD-3-Clause
#include "SvgFixture.h"

#include <offmap/core/ArcWalls.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/SvgMapWriter.h>

#include <cmath>
#include <limits>

namespace offmap::maps {

namespace {

core::Wall straight(double x1, double y1, double x2, double y2) {
    core::Wall wall;
    wall.line = {{x1, y1}, {x2, y2}};
    return wall;
}

}  // namespace

TEST(SvgMapOf, isReadBackWithoutAnyOption) {
    std::vector<core::Wall> walls{straight(-12.34567, -1.5, 3.25, 7.125),
                                  straight(3.25, 7.125, 3.25, 9), straight(5, 5, 6, 6)};
    walls[1].sigma = 0.0125;
    walls[2].height = {-std::numeric_limits<double>::infinity(), 1.1};
    std::vector<std::string> layers{"walls", "walls", "a <\"&'> b"};
    core::Wall like;
    like.height = {0.25, 2};
    for (const auto& piece : core::wallsAlong({{2, 3}, 1.5, 0.3, 4.5}, like)) {
        walls.push_back(piece);
        layers.emplace_back();
    }
    const Drawing drawing = test::parsed(svgMapOf(walls, layers));
    EXPECT_THAT(drawing.layers, testing::ElementsAre("walls", "a <\"&'> b", ""));
    EXPECT_THAT(drawing.warnings, testing::IsEmpty());
    ASSERT_EQ(drawing.walls.size(), walls.size());
    for (size_t i = 0; i < walls.size(); ++i) {
        // Coordinates are written to 0.01 mm, so they are off by half of that.
        EXPECT_THAT(test::ends(drawing.walls[i]), test::near(test::ends(walls[i]), 0.6e-5)) << i;
        const auto middle = core::placeAt(walls[i], 0.5);
        EXPECT_LT(core::distanceTo(drawing.walls[i], middle), 1e-4) << i;
        EXPECT_NEAR(drawing.walls[i].sigma, walls[i].sigma, 1e-9) << i;
        EXPECT_EQ(drawing.walls[i].height, walls[i].height) << i;
        EXPECT_EQ(drawing.layers[drawing.layerOf[i]], layers[i]);
    }
}

TEST(SvgMapOf, wallsThatFollowEachOtherAreOnePath) {
    const std::vector<core::Wall> walls{straight(0, 0, 1, 0), straight(1, 0, 1, 1),
                                        straight(2, 2, 3, 3)};
    const std::string text = svgMapOf(walls, std::vector<std::string>(3));
    size_t paths = 0;
    for (size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1))
        ++paths;
    EXPECT_EQ(paths, 2U);
}

TEST(SvgMapOf, eachWallNeedsALayer) {
    const std::vector<core::Wall> walls{straight(0, 0, 1, 0)};
    EXPECT_THROW(svgMapOf(walls, {}), std::invalid_argument);
    EXPECT_THAT(test::errorOf(svgMapOf({}, {})), testing::HasSubstr("shows no line"));
}

}  // namespace offmap::maps
