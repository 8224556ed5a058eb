// SPDX-License-Identifier: BSD-3-Clause
#include "../support/GridTraversal.h"

#include <offmap/core/LineMap.h>
#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/GridLines.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;
using test::gridFromText;

core::LineMap mapOfGrid(const OccupancyGrid& grid, GridWalls walls) {
    MapOptions options;
    options.gridWalls = walls;
    return core::LineMap(drawingOf(grid, options, "grid", "grid").walls);
}

/// Calls visit(direction, range of the exact traversal) for rays all around that meet something.
template <class Visit>
void forEachRay(const OccupancyGrid& grid, const TPoint2D& origin, const Visit& visit) {
    constexpr int rays = 997;  // a prime: none along an axis or a diagonal but the first
    for (int i = 0; i < rays; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.25) / rays;
        const TPoint2D direction{std::cos(angle), std::sin(angle)};
        visit(direction, test::traversedRange(grid, origin, direction));
    }
}

OccupancyGrid shapesWithin(double resolution) {
    return test::gridOfShape(5, resolution, [](const TPoint2D& p) {
        const bool thick = p.x > 3 && p.x < 3.5;
        const bool diagonal = std::abs(p.x + p.y + 4) < 0.3;
        const bool pillar = std::hypot(p.x - 1, p.y - 2.5) < 0.6;
        const bool box = std::abs(p.x + 1.5) < 0.5 && std::abs(p.y - 3) < 0.25;
        return thick || diagonal || pillar || box;
    });
}

TEST(GridFaceLines, endRaysWhereExactTraversalEnds) {
    const OccupancyGrid grid = shapesWithin(0.1);
    const core::LineMap map = mapOfGrid(grid, GridWalls::Cells);
    size_t hits = 0;
    for (const TPoint2D& origin : {TPoint2D{0.013, 0.007}, TPoint2D{2.317, -3.171}}) {
        forEachRay(grid, origin, [&](const TPoint2D& direction, std::optional<double> expected) {
            const auto hit = map.castRay(origin, direction, 20, 0);
            ASSERT_EQ(hit.has_value(), expected.has_value());
            if (!hit) return;
            ++hits;
            EXPECT_NEAR(hit->range, *expected, 1e-9);  // rounding of sums of some hundred steps
        });
    }
    EXPECT_GT(hits, 1000U);
}

TEST(GridFaceLines, areMergedAlongRows) {
    EXPECT_EQ(gridFaceLines(gridFromText({"....", ".##.", "...."})).size(), 4U);
}

/// Along the normal a line is at most half a cell from the middles of its faces. Traversal meets
/// them up to half a cell further on, in the notch between two, and where two lines meet at a bend
/// of a curve they may do so half a cell outside.
TEST(GridLines, lieNearWhereTraversalEnds) {
    constexpr double resolution = 0.05;
    const OccupancyGrid grid = shapesWithin(resolution);
    const core::LineMap map = mapOfGrid(grid, GridWalls::Lines);
    EXPECT_LT(map.walls().size(), 60U) << "two straight walls, a box and a round pillar";
    const TPoint2D origin{0.013, 0.007};
    size_t hits = 0, otherWall = 0;
    forEachRay(grid, origin, [&](const TPoint2D& direction, std::optional<double> expected) {
        const auto hit = map.castRay(origin, direction, 20, 0);
        if (!expected) return;
        ++hits;
        // Past a corner that is not where that of the cells is.
        if (!hit || std::abs(hit->range - *expected) > 0.5) {
            ++otherWall;
            return;
        }
        const double acrossTheLine = std::abs(hit->range - *expected) * hit->incidence.sine();
        EXPECT_LE(acrossTheLine, 1.5 * resolution);
    });
    EXPECT_GT(hits, 500U);
    EXPECT_LE(otherWall, hits / 100);
}

TEST(GridLines, straightWallIsOneLine) {
    // A half plane at each of many angles: one line, within half a cell of its border.
    for (int degrees = 0; degrees < 90; degrees += 3) {
        const double angle = degrees * std::numbers::pi / 180 + 0.01;
        const TPoint2D normal{std::cos(angle), std::sin(angle)};
        const auto offset = [&](const TPoint2D& p) {
            return p.x * normal.x + p.y * normal.y - 0.3;
        };
        const OccupancyGrid grid =
            test::gridOfShape(20, 1, [&](const TPoint2D& p) { return offset(p) > 0; });
        const auto lines = gridLines(grid, ThinWall::Middle);
        ASSERT_EQ(lines.size(), 1U) << degrees;
        for (const TPoint2D& end : {lines[0].point1, lines[0].point2}) {
            EXPECT_LE(std::abs(offset(end - TPoint2D{20, 20})), 0.5) << degrees;
        }
    }
}

TEST(GridLines, thickWallShowsItsFaceAndItsCorners) {
    const auto lines = gridLines(gridFromText({"........",  //
                                               ".######.",  //
                                               ".######.",  //
                                               ".######.",  //
                                               "........"}),
                                 ThinWall::Middle);
    ASSERT_EQ(lines.size(), 4U);
    for (const TSegment2D& line : lines) {
        for (const TPoint2D& end : {line.point1, line.point2}) {
            constexpr double rounding = 1e-9;
            EXPECT_NEAR(std::abs(end.x - 4), 3, rounding) << end.asString();
            EXPECT_NEAR(std::abs(end.y - 2.5), 1.5, rounding) << end.asString();
        }
    }
}

TEST(GridLines, wallOfOneCellIsOneLineInItsMiddle) {
    const auto grid = gridFromText({"........", ".######.", "........"});
    const auto lines = gridLines(grid, ThinWall::Middle);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].point1.y, 1.5);
    EXPECT_EQ(lines[0].point2.y, 1.5);
    EXPECT_NEAR(lines[0].length(), 6, 1e-9);
    EXPECT_EQ(gridLines(grid, ThinWall::Faces).size(), 4U);
}

TEST(GridLines, wallOfOneCellBeforeTheUnknownIsInItsMiddleToo) {
    const auto lines =
        gridLines(gridFromText({"        ", "########", "........"}), ThinWall::Middle);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].point1.y, 1.5);
}

TEST(GridLines, unknownCellsAreNoWalls) {
    EXPECT_TRUE(gridLines(gridFromText({"....", "    ", "...."}), ThinWall::Middle).empty());
    EXPECT_TRUE(gridLines(gridFromText({"    ", " ## ", "    "}), ThinWall::Middle).empty());
}

TEST(GridLines, greyRimHidesNoWall) {
    const std::vector<std::string> rows{"........", "        ", "        ", "########", "########"};
    EXPECT_EQ(gridLines(gridFromText(rows), ThinWall::Middle).size(), 1U);
    auto wide = rows;
    wide.insert(wide.begin() + 1, "        ");
    EXPECT_TRUE(gridLines(gridFromText(wide), ThinWall::Middle).empty());
}

TEST(GridLines, cellsThatTouchAtACornerAreOneWall) {
    const auto grid =
        test::gridOfShape(10, 1, [](const TPoint2D& p) { return p.x == p.y; });  // a staircase
    const auto lines = gridLines(grid, ThinWall::Middle);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].point1.x, lines[0].point1.y, 1e-9);
    EXPECT_NEAR(lines[0].point2.x, lines[0].point2.y, 1e-9);
}

TEST(GridLines, doorIsAGap) {
    const auto map =
        mapOfGrid(gridFromText({".........", "####.####", "........."}), GridWalls::Lines);
    EXPECT_EQ(map.walls().size(), 2U);
    EXPECT_FALSE(map.castRay({4.5, 0.5}, {0, 1}, 10, 0));
    EXPECT_TRUE(map.castRay({1.5, 0.5}, {0, 1}, 10, 0));
}

TEST(GridDrawing, sigmaGrowsByTheCell) {
    MapOptions options;
    options.sigma = 0.03;
    OccupancyGrid grid = gridFromText({"....", "####", "...."});
    const auto walls = drawingOf(grid, options, "grid", "grid").walls;
    EXPECT_DOUBLE_EQ(walls.at(0).sigma, std::sqrt(0.03 * 0.03 + 1.0 / 12));
}

TEST(GridDrawing, originTurnsAndMovesTheGrid) {
    OccupancyGrid grid = gridFromText({"....", "####", "...."});
    grid.resolution = 0.5;
    grid.origin = {10, 20, std::numbers::pi / 2};
    const auto walls = drawingOf(grid, {}, "grid", "grid").walls;
    ASSERT_EQ(walls.size(), 1U);
    // The row's middle is 0.75 m above the corner, which is to the left once turned.
    EXPECT_NEAR(walls[0].line.point1.x, 10 - 0.75, 1e-9);
    EXPECT_NEAR(std::abs(walls[0].line.point1.y - walls[0].line.point2.y), 2, 1e-9);
}

TEST(GridDrawing, specksAreLeftOutAndCounted) {
    const std::vector<std::string> rows{".#......",  //
                                        "........",  //
                                        "........",  //
                                        ".....##.",  //
                                        ".......#",  //
                                        "........",  //
                                        "........",  //
                                        "########"};
    const Drawing drawing = drawingOf(gridFromText(rows), {}, "grid", "grid");
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(drawing.notes, testing::Contains(testing::HasSubstr("2 specks")));
}

TEST(GridDrawing, rowOfDotsIsNoSpeck) {
    const Drawing drawing =
        drawingOf(gridFromText({"..........", ".#.#.#.#..", ".........."}), {}, "grid", "grid");
    EXPECT_GE(drawing.walls.size(), 4U);
    EXPECT_THAT(drawing.notes, testing::Not(testing::Contains(testing::HasSubstr("speck"))));
}

TEST(GridDrawing, facesOfSpecksAreWallsIfFacesAreAskedFor) {
    MapOptions cells;
    cells.gridWalls = GridWalls::Cells;
    EXPECT_EQ(drawingOf(gridFromText({".....", ".#...", "....."}), cells, "g", "g").walls.size(),
              4U);
}

TEST(GridDrawing, gridWithoutFreeCellTakesUnknownForFree) {
    const Drawing drawing = drawingOf(gridFromText({"    ", "####", "    "}), {}, "grid", "grid");
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(drawing.notes, testing::Contains(testing::HasSubstr("unknown ones are taken")));
}

TEST(GridDrawing, gridWithoutWallIsRefused) {
    const auto refusal = [](const std::vector<std::string>& rows) -> std::string {
        try {
            drawingOf(gridFromText(rows), {}, "grid", "plan.pgm");
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(refusal({"....", "...."}), testing::HasSubstr("plan.pgm: the grid holds no wall"));
    EXPECT_THAT(refusal({"....", ".#..", "...."}), testing::HasSubstr("--map-as grid"));
}

TEST(GridDrawing, invertedGridIsWarnedOf) {
    const Drawing drawing = drawingOf(gridFromText({"####", "#..#", "####"}), {}, "grid", "grid");
    EXPECT_THAT(drawing.warnings, testing::Contains(testing::HasSubstr("inverted")));
}

}  // namespace

}  // namespace offmap::maps
