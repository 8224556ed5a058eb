// SPDX-License-Identifier: BSD-3-Clause
#include "MapFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class MapInfo : public MapFixture {
 protected:
    std::string infoOf(const std::string& walls, const Arguments& more = {}) const {
        writeFile(map_, walls);
        const RunResult run = map("info", more);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(run.err, "");
        return run.out;
    }
};

// 10 + 3 pi + 10 + 6 + 2 + 0.3 m; the arc of half a circle is two walls.
TEST_F(MapInfo, tellsWhatTheMapHolds) {
    const RunResult run = map("info");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("office.lines: text"),
                               HasSubstr("13.00 m by 6.00 m: x 0.00 to 13.00, y 0.00 to 6.00"),
                               HasSubstr("7 (2 of them arcs), 37.7 m in all"),
                               HasSubstr("0.3 m to 10 m long"), HasSubstr("0.02 to 0.1 m"),
                               HasSubstr("1 wall of limited height, from z 0.00 m, up to z 1.10 m"),
                               Not(HasSubstr("warnings"))));
}

TEST_F(MapInfo, jsonTellsTheSame) {
    const auto json = nlohmann::json::parse(map("info", {"--json"}).out);
    EXPECT_EQ(json["format"], "text");
    EXPECT_EQ(json["walls"], 7);
    EXPECT_EQ(json["arcs"], 2);
    EXPECT_NEAR(json["length_m"], 28.3 + 3 * 3.14159265, 1e-6);
    // half a turn of the arc, whose ends are rounded as doubles are
    EXPECT_NEAR(json["extent"]["x_max_m"], 13, 1e-9);
    EXPECT_EQ(json["sigma_max_m"], 0.1);
    EXPECT_EQ(json["z_max_m"], 1.1);
    EXPECT_EQ(json["layers"].size(), 1U);
    EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(MapInfo, layersThatAreLeftOutAreListed) {
    ASSERT_EQ(map("convert", {"-o", folder_ / "plan.dxf"}).exitCode, 0);
    std::string dxf = readFile(folder_ / "plan.dxf");
    // the second entity goes to another layer
    const size_t second = dxf.find("LWPOLYLINE", dxf.find("LWPOLYLINE") + 1);
    dxf.replace(dxf.find("\n  8\n0\n", second), 7, "\n  8\nDOORS\n");
    writeFile(folder_ / "plan.dxf", dxf);
    map_ = folder_ / "plan.dxf";
    const RunResult run = map("info", {"--map-exclude-layer", "doors"});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, AllOf(HasSubstr("lines"), HasSubstr("DOORS"), HasSubstr("left out"),
                               HasSubstr("unit: metres")));
}

TEST_F(MapInfo, sizesBeyondReasonAreSmelt) {
    EXPECT_THAT(infoOf("0 0 12000 0\n0 0 0 8000\n"),
                AllOf(HasSubstr("12 km by 8000 m"), HasSubstr("--map-scale 0.001")));
    EXPECT_THAT(infoOf("0 0 0.12 0\n0 0 0 0.08\n"),
                AllOf(HasSubstr("less than a room"), HasSubstr("--map-scale 100")));
    EXPECT_THAT(infoOf("0 0 12000 0\n0 0 0 8000\n", {"--map-scale", "0.001"}),
                Not(HasSubstr("warnings")));
}

TEST_F(MapInfo, farPlacesAreSmelt) {
    EXPECT_THAT(infoOf("691000 5334000 691010 5334000\n691000 5334000 691000 5334010\n"),
                AllOf(HasSubstr("from its origin"), HasSubstr("--map-origin=-691005,-5334005,0")));
}

TEST_F(MapInfo, islandsAreSmelt) {
    const std::string room = "0 0 8 0\n8 0 8 5\n8 5 0 5\n0 5 0 2\n0 2 0 0\n";
    EXPECT_THAT(infoOf(room + "2 400 9 400\n"), HasSubstr("1 wall stands off the rest by 395 m"));
    EXPECT_THAT(infoOf("-300 0 -300 2\n" + room), HasSubstr("1 wall stands off the rest by 300 m"));
    EXPECT_THAT(infoOf(room + "15 0 15 5\n"), Not(HasSubstr("stands off")));
}

TEST_F(MapInfo, shortWallsAndOddSigmasAreSmelt) {
    EXPECT_THAT(infoOf("0 0 8 0 0\n8 0 8 5 0.8\n8 5 8.005 5\n"),
                AllOf(HasSubstr("1 wall shorter than a centimetre"), HasSubstr("a sigma of 0 "),
                      HasSubstr("a sigma of 0.8 m")));
}

TEST_F(MapInfo, parametersCount) {
    EXPECT_THAT(map("info", {"--set", "map.sigma_m=0.07"}).out, HasSubstr("0.02 to 0.1 m"));
    EXPECT_THAT(infoOf("0 0 8 0\n", {"--set", "map.sigma_m=0.07"}), HasSubstr("0.07 m"));
    expectMapRefused("info", {"--set", "map.sigma_m=thick"}, 1, HasSubstr("map.sigma_m"));
    expectMapRefused("info", {"--config", folder_ / "none.yaml"}, 1, HasSubstr("none.yaml"));
}

TEST_F(MapInfo, badMapsAreRefused) {
    writeFile(map_, "0 0 8\n");
    expectMapRefused("info", {}, 2, HasSubstr("office.lines:1: "));
    writeFile(map_, std::string(2000, '\0'));
    expectMapRefused("info", {}, 2, HasSubstr("office.lines"));
    map_ = folder_.path();
    expectMapRefused("info", {}, 2, HasSubstr("folder"));
    map_ = folder_ / "none.lines";
    expectMapRefused("info", {}, 2, HasSubstr("none.lines"));
}

TEST_F(MapInfo, commandLineIsChecked) {
    expectRefusal({"map"}, 1, HasSubstr("offmap map --help"));
    expectRefusal({"map", "paint", map_}, 1,
                  AllOf(HasSubstr("no subcommand 'paint'"), HasSubstr("offmap map --help")));
    expectRefusal({"map", "info"}, 1, HasSubstr("offmap map info --help"));
    expectMapRefused("info", {"--jsno"}, 1, HasSubstr("--jsno"));
    expectMapRefused("info", {"--map-units", "miles"}, 1, HasSubstr("miles"));
}

}  // namespace
