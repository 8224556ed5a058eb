// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingFixture.h"

#include <offmap/core/ArcWalls.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/DrawingFile.h>

#include <numbers>

namespace {

using namespace offmap;
using namespace offmap::test;
using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DrawingFile : public DrawingFixture {
 protected:
    DrawingFile() {
        core::Wall counter;
        counter.line = {{0, 0}, {6.125, 0}};
        counter.sigma = 0.0625;
        counter.height = {0, 1.125};
        add(counter, "counter");
        core::Wall like;
        for (const core::Wall& wall : core::wallsAlong({{3, 2}, 2, 0.5, pi}, like))
            add(wall, "apse");
        core::Wall wall;
        wall.line = {{6.125, 0}, {6.125, -4}};
        add(wall, "walls");
    }

    void add(const core::Wall& wall, const char* layer) {
        walls_.push_back(wall);
        layerOfEach_.emplace_back(layer);
    }

    /// Lines to the digits that a file has, arcs within what they are drawn and found with:
    /// half a millimetre, and one.
    void expectSame(const maps::Drawing& drawing) const {
        ASSERT_EQ(drawing.walls.size(), walls_.size());
        for (size_t i = 0; i < walls_.size(); ++i) {
            EXPECT_EQ(drawing.layers[drawing.layerOf[i]], layerOfEach_[i]);
            EXPECT_EQ(drawing.walls[i].curvature == 0, walls_[i].curvature == 0);
            const double near = walls_[i].curvature == 0 ? 1e-6 : 0.0015;
            for (const double share : {0.0, 0.3, 0.7, 1.0}) {
                const auto offset =
                    core::placeAt(drawing.walls[i], share) - core::placeAt(walls_[i], share);
                EXPECT_LT(offset.norm(), near) << i;
            }
        }
    }

    std::vector<core::Wall> walls_;
    std::vector<std::string> layerOfEach_;
};

TEST_F(DrawingFile, dxfIsReadBackInMetresWithoutADoubt) {
    const auto drawing = read("plan.dxf", maps::dxfOf(walls_, layerOfEach_));
    expectSame(drawing);
    EXPECT_THAT(drawing.notes, ElementsAre(HasSubstr("unit: metres, by the drawing's $INSUNITS")));
    EXPECT_THAT(drawing.warnings, IsEmpty());
}

TEST_F(DrawingFile, geoJsonIsReadBackInMetresWithoutADoubt) {
    const auto drawing = read("plan.geojson", maps::geoJsonOf(walls_, layerOfEach_));
    expectSame(drawing);
    EXPECT_THAT(drawing.notes, ElementsAre(HasSubstr("coordinates: local")));
    EXPECT_THAT(drawing.warnings, IsEmpty());
    EXPECT_EQ(drawing.walls[0].sigma, 0.0625);
    EXPECT_EQ(drawing.walls[0].height, core::Interval(0, 1.125));
    EXPECT_EQ(drawing.walls.back().height, core::Interval::everything());
}

TEST_F(DrawingFile, sameWallsGiveTheSameBytes) {
    EXPECT_EQ(maps::dxfOf(walls_, layerOfEach_), maps::dxfOf(walls_, layerOfEach_));
    EXPECT_EQ(maps::geoJsonOf(walls_, layerOfEach_), maps::geoJsonOf(walls_, layerOfEach_));
}

TEST_F(DrawingFile, namesThatDxfForbidsAreChanged) {
    layerOfEach_[0] = "a*b/c";
    layerOfEach_[1] = "";
    EXPECT_THAT(read("plan.dxf", maps::dxfOf(walls_, layerOfEach_)).layers,
                ElementsAre("a_b_c", "0", "apse", "walls"));
}

TEST_F(DrawingFile, eachWallNeedsALayersName) {
    layerOfEach_.pop_back();
    EXPECT_THROW(maps::dxfOf(walls_, layerOfEach_), std::invalid_argument);
    EXPECT_THROW(maps::geoJsonOf(walls_, layerOfEach_), std::invalid_argument);
}

}  // namespace
