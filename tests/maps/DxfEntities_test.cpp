// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

#include <offmap/core/WallGeometry.h>

#include <cmath>
#include <numbers>

namespace {

using namespace offmap;
using namespace offmap::test;
using std::numbers::pi;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

using DxfEntities = DrawingFixture;

double lengthOf(const maps::Drawing& drawing) {
    double length = 0;
    for (const core::Wall& wall : drawing.walls) length += core::lengthOf(wall);
    return length;
}

/// Of arcs that are to be exact: the places that GDAL computes have 15 digits.
constexpr double exact = 1e-9;

TEST_F(DxfEntities, lineIsAWallOfItsLayer) {
    const auto drawing = readDxf("0 LINE 8 WALLS 10 1 20 2 30 0 11 4 21 3 31 0");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(1, 2, 4, 3)));
    EXPECT_THAT(drawing.layers, ElementsAre("WALLS"));
    EXPECT_EQ(drawing.format, "DXF");
}

TEST_F(DxfEntities, arcIsAnArc) {
    const auto drawing = readDxf("0 ARC 8 W 10 4 20 1 40 2 50 300 51 30");
    ASSERT_EQ(drawing.walls.size(), 1U) << "a quarter of a circle";
    EXPECT_NEAR(std::abs(drawing.walls[0].curvature), 1 / 2.0, exact);
    EXPECT_NEAR(core::lengthOf(drawing.walls[0]), 2 * pi / 2, exact);
    const mrpt::math::TPoint2D middle{4 + 2 * std::cos(-pi / 12), 1 + 2 * std::sin(-pi / 12)};
    EXPECT_NEAR(core::distanceTo(drawing.walls[0], middle), 0, exact);
}

TEST_F(DxfEntities, circleIsFourArcs) {
    const auto drawing = readDxf("0 CIRCLE 8 COLUMNS 10 2 20 2 40 0.25");
    ASSERT_EQ(drawing.walls.size(), 4U);
    for (const core::Wall& wall : drawing.walls) {
        EXPECT_NEAR(std::abs(wall.curvature), 4, 1e-6) << "0.25 m to a tenth of a micrometre";
    }
    EXPECT_NEAR(lengthOf(drawing), 2 * pi * 0.25, exact);
}

TEST_F(DxfEntities, largeArcKeepsWithinTwoMillimetres) {
    const auto drawing = readDxf("0 CIRCLE 8 W 10 0 20 0 40 150");
    EXPECT_EQ(drawing.walls.size(), 4U);
    EXPECT_NEAR(lengthOf(drawing), 2 * pi * 150, 1e-6);
}

TEST_F(DxfEntities, polylineHasItsBulges) {
    // a bulge is the tangent of a quarter of the angle: 1 is half a circle
    const auto drawing = readDxf(
        "0 POLYLINE 8 W 66 1 70 1 0 VERTEX 8 W 10 0 20 0 42 1 0 VERTEX 8 W 10 2 20 0 0 SEQEND");
    ASSERT_EQ(drawing.walls.size(), 3U) << "half a circle and the way back";
    EXPECT_NEAR(lengthOf(drawing), pi + 2, exact);
    EXPECT_NEAR(core::distanceTo(drawing.walls[0], {1 - std::sqrt(0.5), -std::sqrt(0.5)}), 0, exact)
        << "a positive bulge lies on the right";
}

TEST_F(DxfEntities, lightweightPolylineHasBulgesAndCloses) {
    const auto drawing = readDxf(
        "0 LWPOLYLINE 8 W 100 AcDbEntity 100 AcDbPolyline 90 3 70 1 10 0 20 0 "
        "42 0.41421356237309503 10 1 20 1 10 0 20 2");
    ASSERT_EQ(drawing.walls.size(), 3U);
    EXPECT_NEAR(std::abs(drawing.walls[0].curvature), 1, exact);
    EXPECT_THAT(drawing.walls[1], IsLine(1, 1, 0, 2));
    EXPECT_THAT(drawing.walls[2], IsLine(0, 2, 0, 0));
}

TEST_F(DxfEntities, ellipseIsFollowedWithinTwoMillimetres) {
    const auto drawing = readDxf(
        "0 ELLIPSE 8 W 100 AcDbEntity 100 AcDbEllipse 10 0 20 0 30 0 11 2 21 0 31 0 40 0.5 "
        "41 0 42 6.283185307179586");
    EXPECT_LT(drawing.walls.size(), 100U) << "few arcs, not one piece for each half degree";
    for (double angle = 0; angle < 2 * pi; angle += 0.01) {
        const mrpt::math::TPoint2D place{2 * std::cos(angle), std::sin(angle)};
        double nearest = 1;
        for (const core::Wall& wall : drawing.walls) {
            nearest = std::min(nearest, core::distanceTo(wall, place));
        }
        EXPECT_LT(nearest, 0.002) << angle;
    }
}

TEST_F(DxfEntities, splineEndsAtItsLastControlPoint) {
    const auto drawing = readDxf(
        "0 SPLINE 8 W 100 AcDbEntity 100 AcDbSpline 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 "
        "40 1 40 1 40 1 10 0 20 0 30 0 10 1 20 2 30 0 10 2 20 2 30 0 10 3 20 0 30 0");
    ASSERT_FALSE(drawing.walls.empty());
    EXPECT_NEAR((drawing.walls.front().line.point1 - mrpt::math::TPoint2D(0, 0)).norm(), 0, exact);
    EXPECT_NEAR((drawing.walls.back().line.point2 - mrpt::math::TPoint2D(3, 0)).norm(), 0, exact);
    // the curve of degree 3 is at half of its parameter where its control points' weights
    // 1, 3, 3, 1 put it: (1.5, 1.5); GDAL draws 31 pieces of 0.13 m, bulging by less than 2 mm
    double nearest = 1;
    for (const core::Wall& wall : drawing.walls) {
        nearest = std::min(nearest, core::distanceTo(wall, {1.5, 1.5}));
    }
    EXPECT_LT(nearest, 0.004);
}

TEST_F(DxfEntities, blocksArePutInPlace) {
    const char* door =
        "0 BLOCK 8 0 2 DOOR 70 0 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 "
        "0 LINE 8 GLASS 10 0 20 0 11 0 21 1 0 ENDBLK 8 0";
    const auto drawing = readDxf("0 INSERT 8 DOORS 2 DOOR 10 10 20 5 41 2 42 3 50 90", door);
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(10, 5, 10, 7), IsLine(10, 5, 7, 5)));
    EXPECT_EQ(drawing.layers[drawing.layerOf[0]], "DOORS") << "layer 0 is that of the insert";
    EXPECT_EQ(drawing.layers[drawing.layerOf[1]], "GLASS");
}

TEST_F(DxfEntities, arrayOfBlocksIsRepeated) {
    const char* post = "0 BLOCK 8 0 2 P 70 0 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 0 ENDBLK 8 0";
    const auto drawing = readDxf("0 INSERT 8 W 2 P 10 0 20 0 70 2 71 2 44 3 45 4", post);
    EXPECT_THAT(drawing.walls,
                testing::UnorderedElementsAre(IsLine(0, 0, 1, 0), IsLine(3, 0, 4, 0),
                                              IsLine(0, 4, 1, 4), IsLine(3, 4, 4, 4)));
}

TEST_F(DxfEntities, solidIsItsOutline) {
    // the third and fourth corner of this class are swapped
    const auto drawing = readDxf("0 SOLID 8 S 10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(0, 0, 1, 0), IsLine(1, 0, 1, 1),
                                           IsLine(1, 1, 0, 1), IsLine(0, 1, 0, 0)));
}

TEST_F(DxfEntities, uprightFaceIsALine) {
    const auto drawing =
        readDxf("0 3DFACE 8 F 10 0 20 0 30 0 11 4 21 0 31 0 12 4 22 0 32 3 13 0 23 0 33 3");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(0, 0, 4, 0), IsLine(4, 0, 0, 0)));
    EXPECT_THAT(drawing.notes, Contains(HasSubstr("heights (z)")));
}

TEST_F(DxfEntities, uprightLinesAreCounted) {
    const auto drawing = readDxf(
        "0 LINE 8 W 10 1 20 1 30 0 11 1 21 1 31 3 0 LINE 8 W 10 0 20 0 30 0 11 1 21 0 31 0");
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(drawing.notes, Contains(HasSubstr("1 upright lines")));
}

TEST_F(DxfEntities, whatIsNoWallIsLeftOutAndTold) {
    const auto drawing = readDxf(
        "0 LINE 8 W 10 0 20 0 11 4 21 0 "
        "0 HATCH 5 1F 8 HATCHES 100 AcDbEntity 100 AcDbHatch 10 0 20 0 30 0 210 0 220 0 230 1 "
        "2 SOLID 70 1 71 0 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 1 20 0 10 1 20 1 97 0 75 0 76 1 "
        "98 0 "
        "0 DIMENSION 8 DIMS 100 AcDbEntity 100 AcDbDimension 2 *D1 10 4 20 5 30 0 11 2 21 5 31 0 "
        "70 33 100 AcDbAlignedDimension 13 0 23 0 33 0 14 4 24 0 34 0 "
        "0 LEADER 8 DIMS 100 AcDbEntity 100 AcDbLeader 76 2 10 0 20 0 30 0 10 1 20 1 30 0 "
        "0 TEXT 8 TEXT 10 0 20 0 40 1 1 hello 0 POINT 8 POINTS 10 0 20 0 "
        "0 LINE 8 PAPER 67 1 10 0 20 0 11 1 21 0",
        "0 BLOCK 8 0 2 *D1 70 1 10 0 20 0 0 LINE 8 0 10 0 20 5 11 4 21 5 0 ENDBLK 8 0");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(0, 0, 4, 0)));
    for (const char* kind : {"hatches (1)", "dimensions (1)", "leaders (1)", "points and texts (2)",
                             "entities of the paper space (1)"}) {
        EXPECT_THAT(drawing.notes, Contains(HasSubstr(kind)));
    }
    EXPECT_THAT(drawing.layers, testing::IsSupersetOf({"W", "HATCHES", "DIMS", "TEXT", "POINTS"}))
        << "so that --map-exclude-layer finds them";
}

TEST_F(DxfEntities, hiddenLayersAreLeftOutUnlessNamed) {
    const std::string bytes =
        dxf("0 LINE 8 W 10 0 20 0 11 4 21 0 0 LINE 8 OFF 10 0 20 1 11 4 21 1 "
            "0 LINE 8 FROZEN 10 0 20 2 11 4 21 2 0 LINE 8 W 60 1 10 0 20 3 11 4 21 3");
    const auto shown = read("plan.dxf", bytes);
    EXPECT_THAT(shown.walls, ElementsAre(IsLine(0, 0, 4, 0)));
    EXPECT_THAT(shown.notes, Contains(HasSubstr("off or frozen (3)")));
    maps::MapOptions options;
    options.layers = {"off", "fro*"};
    EXPECT_THAT(read("plan.dxf", bytes, options).walls,
                ElementsAre(IsLine(0, 0, 4, 0), IsLine(0, 1, 4, 1), IsLine(0, 2, 4, 2)));
}

TEST_F(DxfEntities, unknownEntitiesAreWarnedOf) {
    const auto drawing =
        readDxf("0 LINE 8 W 10 0 20 0 11 4 21 0 0 AEC_WALL 8 W 10 0 20 0 0 AEC_WALL 8 W 10 0 20 1");
    EXPECT_THAT(drawing.warnings, Contains(HasSubstr("not read: 2 AEC_WALL")));
}

TEST_F(DxfEntities, drawingOfTheFirstReleasesHasNoHeader) {
    const auto drawing = read("plan.dxf",
                              "0\r\nSECTION\r\n2\r\nENTITIES\r\n0\r\nLINE\r\n8\r\nW\r\n"
                              "10\r\n0\r\n20\r\n0\r\n11\r\n4\r\n21\r\n0\r\n"
                              "0\r\nENDSEC\r\n0\r\nEOF\r\n");
    EXPECT_THAT(drawing.walls, ElementsAre(IsLine(0, 0, 4, 0)));
}

}  // namespace
