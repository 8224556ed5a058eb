// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

namespace {

using namespace offmap;
using namespace offmap::test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DxfUnits : public DrawingFixture {
 protected:
    maps::Drawing lineOf(double length, const std::string& header,
                         const maps::MapOptions& options = {}) const {
        const std::string entity = "0 LINE 8 W 10 0 20 0 11 " + std::to_string(length) + " 21 0";
        return read("plan.dxf", dxf(entity, "", header), options);
    }

    static double length(const maps::Drawing& drawing) { return drawing.walls.at(0).line.length(); }
};

TEST_F(DxfUnits, insunitsIsHonouredAndTold) {
    constexpr std::pair<int, double> factors[] = {
        {1, 0.0254}, {2, 0.3048},  {4, 0.001}, {5, 0.01},
        {6, 1},      {10, 0.9144}, {14, 0.1},  {21, 1200.0 / 3937.0}};
    for (const auto& [code, metres] : factors) {
        const auto drawing = lineOf(4000, "9 $INSUNITS 70 " + std::to_string(code));
        EXPECT_DOUBLE_EQ(length(drawing), 4000 * metres) << code;
        EXPECT_THAT(drawing.notes, Contains(HasSubstr("by the drawing's $INSUNITS"))) << code;
    }
}

TEST_F(DxfUnits, withoutItAUnitIsAMetre) {
    for (const char* header : {"9 $ACADVER 1 AC1009", "9 $INSUNITS 70 0", "9 $INSUNITS 70 18",
                               "9 $INSUNITS 70 -4", "9 $INSUNITS 70 x", "9 $INSUNITS 40 4"}) {
        const auto drawing = lineOf(10, header);
        EXPECT_DOUBLE_EQ(length(drawing), 10) << header;
        EXPECT_THAT(drawing.notes,
                    ElementsAre(HasSubstr("unit: metres, as the drawing states none")));
    }
}

TEST_F(DxfUnits, optionOverrides) {
    maps::MapOptions options;
    options.units = maps::LengthUnit::Centimetre;
    const auto drawing = lineOf(1000, "9 $INSUNITS 70 1", options);
    EXPECT_DOUBLE_EQ(length(drawing), 10);
    EXPECT_THAT(drawing.notes, ElementsAre("unit: cm, by --map-units"));
}

TEST_F(DxfUnits, smallMapIsWarnedOf) {
    EXPECT_THAT(lineOf(10.6, "9 $INSUNITS 70 1").warnings,
                ElementsAre(testing::AllOf(HasSubstr("0.269 m"), HasSubstr("--map-units m"))));
    EXPECT_THAT(lineOf(10.6, "9 $INSUNITS 70 6").warnings, IsEmpty());
}

TEST_F(DxfUnits, millimetresWithoutUnitAreWarnedOf) {
    EXPECT_THAT(lineOf(10600, "9 $INSUNITS 70 0").warnings,
                ElementsAre(testing::AllOf(HasSubstr("11 km"), HasSubstr("--map-units mm"))));
}

TEST_F(DxfUnits, scaleOfTheUserMakesItPlausible) {
    maps::MapOptions options;
    options.scale = 0.001;
    EXPECT_THAT(lineOf(10600, "9 $INSUNITS 70 0", options).warnings, IsEmpty());
}

TEST_F(DxfUnits, arcsKeepTheirShapeInAnyUnit) {
    const auto drawing =
        read("plan.dxf", dxf("0 CIRCLE 8 W 10 0 20 0 40 2000", "", "9 $INSUNITS 70 4"));
    ASSERT_EQ(drawing.walls.size(), 4U);
    EXPECT_NEAR(std::abs(drawing.walls[0].curvature), 0.5, 1e-9);
}

}  // namespace
