// SPDX-License-Identifier: BSD-3-Clause
#include "SvgFixture.h"

#include <offmap/core/LineMap.h>
#include <offmap/core/WallGeometry.h>

namespace offmap::maps {

namespace {

using test::ends;
using test::errorOf;
using test::inSvg;
using test::parsed;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double exact = 1e-9;  // [m] coordinates of metres, after a few roundings of 1e-16

/// The length of all walls.
double length(const Drawing& drawing) {
    double sum = 0;
    for (const core::Wall& wall : drawing.walls) sum += core::lengthOf(wall);
    return sum;
}

}  // namespace

TEST(SvgMap, lowerLeftOfTheViewBoxIsTheOriginAndYGoesUp) {
    const auto drawing = parsed(
        "<svg width='4000mm' height='3000mm' viewBox='10 20 400 300'>"
        "<line x1='10' y1='320' x2='410' y2='20'/></svg>");
    ASSERT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(ends(drawing.walls[0]), test::near({0, 0, 4, 3}, exact));
    EXPECT_EQ(drawing.format, "SVG");
    EXPECT_TRUE(drawing.isDrawnByHand);
}

TEST(SvgMap, unitsOfWidthAndHeightMakeUserUnitsLengths) {
    // Each sheet is 96 px = 1 in wide, and so is the line.
    for (const char* size : {"96", "96px", "1in", "25.4mm", "2.54cm", "72pt", "6pc"}) {
        const auto drawing = parsed(std::string("<svg width='") + size + "' height='" + size +
                                    "' viewBox='0 0 7 7'><path d='M0 7h7'/></svg>");
        EXPECT_THAT(ends(drawing.walls.at(0)), test::near({0, 0, 0.0254, 0}, exact)) << size;
    }
}

TEST(SvgMap, withoutAPhysicalSizeAUserUnitIsAPixelAndANoteSaysSo) {
    for (const char* root :
         {"<svg viewBox='0 0 96 96'>", "<svg width='100%' height='100%' viewBox='0 0 96 96'>",
          "<svg width='96' height='96'>"}) {
        const auto drawing = parsed(std::string(root) + "<path d='M0 96H96'/></svg>");
        EXPECT_THAT(ends(drawing.walls.at(0)), test::near({0, 0, 0.0254, 0}, exact)) << root;
        EXPECT_THAT(drawing.notes, testing::Contains(HasSubstr("1/96 inch"))) << root;
    }
}

TEST(SvgMap, unitsAskedForAreThoseOfTheUserUnit) {
    MapOptions options;
    options.units = LengthUnit::Centimetre;
    const auto drawing = parsed(
        "<svg width='420mm' height='297mm' viewBox='0 0 1000 500'>"
        "<line y1='500' x2='1000' y2='500'/></svg>",
        options);
    EXPECT_THAT(ends(drawing.walls.at(0)), test::near({0, 0, 10, 0}, exact));
    EXPECT_THAT(drawing.warnings, testing::IsEmpty());
}

TEST(SvgMap, planAsLargeAsItsPaperIsWarnedOf) {
    const auto drawing = parsed(
        "<svg width='420mm' height='297mm' viewBox='0 0 420 297'>"
        "<rect width='300' height='200'/></svg>");
    EXPECT_THAT(drawing.warnings, ElementsAre(AllOf(HasSubstr("0.3 m wide and 0.2 m high"),
                                                    HasSubstr("--map-scale 100"))));
    MapOptions scaled;
    scaled.scale = 50;
    EXPECT_THAT(parsed("<svg width='420mm' height='297mm' viewBox='0 0 420 297'>"
                       "<rect width='300' height='200'/></svg>",
                       scaled)
                    .warnings,
                testing::IsEmpty());
}

TEST(SvgMap, allShapesAreRead) {
    EXPECT_NEAR(length(parsed(inSvg("<rect x='1' y='1' width='3' height='2'/>"))), 10, exact);
    // four straight pieces shorter by twice the radius, four quarters of a circle
    EXPECT_NEAR(length(parsed(inSvg("<rect width='3' height='2' rx='0.5'/>"))), 6 + M_PI, exact);
    EXPECT_NEAR(length(parsed(inSvg("<polyline points='0,0 3,0 3 4'/>"))), 7, exact);
    EXPECT_NEAR(length(parsed(inSvg("<polygon points='0,0 3,0 3 4'/>"))), 12, exact);
    EXPECT_NEAR(length(parsed(inSvg("<circle cx='5' cy='5' r='2'/>"))), 4 * M_PI, exact);
    EXPECT_NEAR(length(parsed(inSvg("<path d='M0 0h3v4z m5 0 l1 0'/>"))), 13, exact);
    EXPECT_EQ(parsed(inSvg("<polyline points=' '/><path/><path d='none'/><rect/><circle/>"
                           "<line x2='1'/>"))
                  .walls.size(),
              1U);
}

TEST(SvgMap, circlesBecomeArcsWhereverTransformsKeepThemRound) {
    // Two anisotropic steps, the second of which takes back the first.
    const auto drawing =
        parsed(inSvg("<g transform='rotate(30) scale(2 1)'><ellipse cx='3' cy='-4' rx='1' ry='2' "
                     "transform='translate(1 1)'/></g>"));
    EXPECT_EQ(drawing.walls.size(), 4U);
    // clockwise, as on a paper whose y goes down
    for (const core::Wall& wall : drawing.walls) EXPECT_NEAR(wall.curvature, -0.5, exact);
    EXPECT_NEAR(length(drawing), 4 * M_PI, exact);
}

TEST(SvgMap, arcsOfPathsBendAsDrawn) {
    // From (0, 0) on the paper to the right; sweep 1 goes clockwise on paper: up and over.
    for (const auto& [flags, curvature, sweptLength] : {std::tuple{"0 1", -1.0, M_PI / 2},
                                                        {"0 0", 1.0, M_PI / 2},
                                                        {"1 1", -1.0, 1.5 * M_PI},
                                                        {"1 0", 1.0, 1.5 * M_PI}}) {
        const auto drawing = parsed(
            inSvg(std::string("<path d='M5 5 a1 1 0 ") + flags + " 1.4142135623730951 0'/>"));
        EXPECT_NEAR(length(drawing), sweptLength, 1e-7) << flags;  // the root of 2, a grazing arc
        for (const core::Wall& wall : drawing.walls) EXPECT_NEAR(wall.curvature, curvature, 1e-7);
    }
}

TEST(SvgMap, ellipsesAndBeziersKeepWithinTheirFlatness) {
    // x = 3 cos t, y = 2 sin t about (5, 5): no point of a chord is further off than allowed, by
    // |x/3, y/2| <= 1 and >= 1 - 1 mm/2 m.
    const auto ellipse = parsed(inSvg("<ellipse cx='5' cy='5' rx='3' ry='2'/>"));
    EXPECT_GT(ellipse.walls.size(), 20U);
    for (const core::Wall& wall : ellipse.walls) {
        const auto middle = core::placeAt(wall, 0.5);
        const double level = std::hypot((middle.x - 5) / 3, (middle.y - 5) / 2);
        EXPECT_LE(level, 1 + exact);
        EXPECT_GE(level, 1 - 0.001 / 2);
    }
    // a cubic that is a parabola, y = x^2/4 off the lower edge, and as a quadratic
    for (const char* path :
         {"M0 10 C 1.3333333333333333 10 2.6666666666666667 8.6666666666666667 4 6",
          "M0 10 Q 2 10 4 6"}) {
        const auto parabola = parsed(inSvg(std::string("<path d='") + path + "'/>"));
        EXPECT_GT(parabola.walls.size(), 10U);
        for (const core::Wall& wall : parabola.walls) {
            const auto middle = core::placeAt(wall, 0.5);
            EXPECT_NEAR(middle.y, middle.x * middle.x / 4, 0.001 * std::hypot(1, middle.x / 2));
        }
    }
}

TEST(SvgMap, endsOfPiecesMeetExactly) {
    const auto drawing = parsed(
        inSvg("<path transform='rotate(17)' d='M1 1 L2 1 A2 2 0 0 1 4 3 C 5 3 6 4 6 5 l1 1 z'/>"));
    for (size_t i = 0; i < drawing.walls.size(); ++i) {
        const auto& next = drawing.walls[(i + 1) % drawing.walls.size()];
        EXPECT_EQ(drawing.walls[i].line.point2, next.line.point1) << i;
    }
    EXPECT_NO_THROW(core::LineMap(drawing.walls)) << "a wall that no map takes";
}

}  // namespace offmap::maps
