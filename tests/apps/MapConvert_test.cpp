// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "MapFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class MapConvert : public MapFixture {
 protected:
    Path converted(const std::string& name, const Arguments& more = {}) const {
        const Path out = folder_ / name;
        Arguments arguments{"-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = map("convert", arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_THAT(run.out, HasSubstr("wrote   " + out.string()));
        return out;
    }

    /// Both ways, so that nothing is missing and nothing is there in addition.
    void expectSameWalls(const Path& file, double tolerance) const {
        const auto before = wallsIn(map_).walls, after = wallsIn(file).walls;
        EXPECT_LE(farthestFrom(before, after), tolerance) << file;
        EXPECT_LE(farthestFrom(after, before), tolerance) << file;
    }

    /// Of the walls as they were, by the nearest wall of the file.
    static const offmap::core::Wall& nearest(const std::vector<offmap::core::Wall>& walls,
                                             const mrpt::math::TPoint2D& place) {
        return *std::ranges::min_element(
            walls, {}, [&](const auto& wall) { return offmap::core::distanceTo(wall, place); });
    }
};

// Text has tenths of a millimetre and millionths of a degree: half a step of x and y each, and as
// much again of the arc's centre and radius.
TEST_F(MapConvert, textKeepsEverything) {
    const Path file = converted("copy.lines");
    expectSameWalls(file, 2e-4);
    const auto before = wallsIn(map_).walls, after = wallsIn(file).walls;
    ASSERT_EQ(after.size(), before.size());
    for (size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(after[i].sigma, before[i].sigma, 5e-5);
        EXPECT_EQ(after[i].height, before[i].height);
        EXPECT_NEAR(after[i].curvature, before[i].curvature, 2e-5);
    }
}

// Chords keep within half a millimetre of their arc, coordinates have six digits or more.
TEST_F(MapConvert, drawingsHaveTheSameWalls) {
    for (const char* name : {"copy.dxf", "copy.geojson", "copy.json"}) {
        expectSameWalls(converted(name), 6e-4);
    }
}

// Hundredths of a millimetre; arcs stay arcs.
TEST_F(MapConvert, svgKeepsEverything) {
    const Path file = converted("copy.svg");
    expectSameWalls(file, 2e-5);
    const auto after = wallsIn(file).walls;
    ASSERT_EQ(after.size(), wallsIn(map_).walls.size());
    EXPECT_NEAR(nearest(after, {0, 3}).sigma, 0.1, 1e-9);
    EXPECT_EQ(nearest(after, {2, 3}).height, offmap::core::Interval(0, 1.1));
    // a radius of 3 m whose ends are rounded
    EXPECT_NEAR(std::abs(nearest(after, {13, 3}).curvature), 1.0 / 3, 1e-5);
}

// A wall lies anywhere in its cell, whose diagonal is 0.071 m; lines keep within half a cell of
// 0.05 m of the cells' faces.
TEST_F(MapConvert, gridsHaveTheSameWalls) {
    for (const char* name : {"copy.gridmap", "copy.gridmap.gz", "copy.yaml"}) {
        expectSameWalls(converted(name), 0.096);
    }
}

TEST_F(MapConvert, geoJsonKeepsSigmaAndHeight) {
    const auto after = wallsIn(converted("copy.geojson")).walls;
    EXPECT_NEAR(nearest(after, {0, 3}).sigma, 0.1, 1e-9);
    EXPECT_NEAR(nearest(after, {2, 3}).sigma, 0.02, 1e-9);
    EXPECT_EQ(nearest(after, {2, 3}).height, offmap::core::Interval(0, 1.1));
}

TEST_F(MapConvert, dxfTellsWhatItLoses) {
    const RunResult run = map("convert", {"-o", folder_ / "copy.dxf"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, AllOf(HasSubstr("2 walls of a sigma of their own lose it"),
                               HasSubstr("1 wall of limited height loses it")));
    EXPECT_EQ(map("convert", {"-o", folder_ / "copy.svg"}).err, "");
}

TEST_F(MapConvert, rosMapIsAPictureAndItsYaml) {
    const Path file = converted("plan.yaml", {"--resolution", "0.1"});
    EXPECT_THAT(readFile(file),
                AllOf(HasSubstr("image: \"plan.pgm\""), HasSubstr("resolution: 0.1"),
                      HasSubstr("origin: [-1.000000, -1.000000")));
    // 13 m by 6 m, and 1 m around
    EXPECT_THAT(readFile(folder_ / "plan.pgm"), testing::StartsWith("P5\n150 80\n255\n"));
    EXPECT_THAT(folder_.names(),
                testing::UnorderedElementsAre("office.lines", "plan.yaml", "plan.pgm"));
}

TEST_F(MapConvert, gridMapIsPackedByItsName) {
    const std::string plain = readFile(converted("plan.gridmap"));
    EXPECT_THAT(plain.substr(0, 64), HasSubstr("COccupancyGridMap2D"));
    EXPECT_EQ(gunzippedFile(converted("plan.gridmap.gz")), plain);
}

// A real scan of an office: drawings reduce it like the text map within 2 %, grids within 3 %.
TEST_F(MapConvert, everyFormatReducesAlike) {
    OFFMAP_NEEDS_SHARED_DATA();
    const auto removedWith = [&](const Path& plan) {
        map_ = plan;
        const Path report = folder_ / "report.json";
        const RunResult run =
            reduceLog(sharedData("room/room1.rawlog"), {"--report", report, "--force"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return nlohmann::json::parse(readFile(report))["totals"]["points_removed"].get<double>();
    };
    const Path plan = sharedData("room/room.lines");
    const double expected = removedWith(plan);
    EXPECT_GT(expected, 10'000);
    for (const char* name :
         {"room.txt", "room.dxf", "room.geojson", "room.svg", "room.gridmap.gz", "room.yaml"}) {
        map_ = plan;
        const std::string extension = Path(name).extension();
        const bool isGrid = extension == ".gz" || extension == ".yaml";
        EXPECT_NEAR(removedWith(converted(name)), expected, (isGrid ? 0.03 : 0.02) * expected)
            << name;
    }
}

TEST_F(MapConvert, mapIsPlacedAsAsked) {
    const auto walls = wallsIn(converted("moved.lines", {"--map-origin", "100,50,90"})).walls;
    // (10, 0) turned by 90 degrees
    EXPECT_NEAR(walls[0].line.point2.x, 100, 1e-4);
    EXPECT_NEAR(walls[0].line.point2.y, 60, 1e-4);
}

TEST_F(MapConvert, shortestWallsAreLeftOutAloud) {
    writeFile(map_, "0 0 1 0\n2 2 2.0001 2\n");
    const RunResult run = map("convert", {"-o", folder_ / "copy.lines"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, HasSubstr("1 wall of less than 0.2 mm left out"));
    EXPECT_EQ(wallsIn(folder_ / "copy.lines").walls.size(), 1U);
    writeFile(map_, "2 2 2.0001 2\n");
    expectMapRefused("convert", {"-o", folder_ / "new.lines"}, 2, HasSubstr("shorter than 0.2 mm"));
}

TEST_F(MapConvert, unknownExtensionListsTheKnownOnes) {
    for (const char* name : {"copy.dwg", "copy", "gridmap", ".dxf"}) {
        expectMapRefused("convert", {"-o", folder_ / name}, 1,
                         AllOf(HasSubstr(name), HasSubstr(".lines, .txt, .dxf, .geojson")));
    }
}

TEST_F(MapConvert, existingFilesNeedForce) {
    writeFile(folder_ / "plan.pgm", "my holiday");
    expectMapRefused("convert", {"-o", folder_ / "plan.yaml"}, 2,
                     AllOf(HasSubstr("plan.pgm exists already"), HasSubstr("--force")));
    EXPECT_EQ(map("convert", {"-o", folder_ / "plan.yaml", "--force"}).exitCode, 0);
    expectMapRefused("convert", {"-o", folder_ / "plan.yaml"}, 2, HasSubstr("plan.yaml exists"));
}

TEST_F(MapConvert, inputIsNotReplaced) {
    expectMapRefused("convert", {"-o", map_, "--force"}, 1,
                     HasSubstr("MAP and OUT are the same file"));
}

TEST_F(MapConvert, folderThatIsNotThereIsNamed) {
    for (const char* name : {"copy.lines", "copy.dxf", "copy.gridmap", "copy.yaml"}) {
        expectMapRefused("convert", {"-o", folder_ / "plans" / name}, 2,
                         AllOf(HasSubstr((folder_ / "plans").string()), HasSubstr("folder")));
    }
}

TEST_F(MapConvert, folderThatIsNotWritableIsNamed) {
    const Path locked = folder_ / "locked";
    std::filesystem::create_directory(locked);
    std::filesystem::permissions(locked, std::filesystem::perms(0555));
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
    for (const char* name : {"copy.lines", "copy.geojson", "copy.yaml"}) {
        expectRefusal({"map", "convert", map_, "-o", locked / name}, 2,
                      AllOf(HasSubstr(locked.string()), HasSubstr("make its folder writable")),
                      {.user = unprivileged()});
    }
}

TEST_F(MapConvert, hugeGridIsRefused) {
    writeFile(map_, "0 0 1000000 0\n0 0 0 1000000\n");
    expectMapRefused("convert", {"-o", folder_ / "plan.gridmap"}, 2, HasSubstr("cells"));
}

TEST_F(MapConvert, badMapsAreRefused) {
    writeFile(map_, "");
    expectMapRefused("convert", {"-o", folder_ / "plan.dxf"}, 2, HasSubstr("holds no wall"));
    map_ = folder_ / "missing.lines";
    expectMapRefused("convert", {"-o", folder_ / "plan.dxf"}, 2,
                     AllOf(HasSubstr("missing.lines"), HasSubstr("No such file")));
    map_ = folder_.path();
    expectMapRefused("convert", {"-o", folder_ / "plan.dxf"}, 2, HasSubstr("folder"));
}

}  // namespace
