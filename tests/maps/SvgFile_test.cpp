// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/SharedData.h"
#include "../support/TemporaryFolder.h"
#include "SvgFixture.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapFile.h>

namespace offmap::maps {

namespace {

using offmap::test::TemporaryFolder;
using offmap::test::writeFile;
using testing::AllOf;
using testing::HasSubstr;

std::string errorOfFile(const std::filesystem::path& file, const MapOptions& options = {}) {
    try {
        readMap(file, options);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

const MapLayer& layerOf(const MapOfFile& map, std::string_view name) {
    const auto found = std::ranges::find(map.layers, name, &MapLayer::name);
    EXPECT_NE(found, map.layers.end()) << name;
    return *found;
}

}  // namespace

TEST(SvgFile, mayBeCompressed) {
    const TemporaryFolder folder;
    const std::string text = test::inSvg("<path d='M0 10h3'/>");
    writeFile(folder / "a.svg", text);
    writeFile(folder / "b.SVGZ", offmap::test::gzipped(text));
    for (const char* name : {"a.svg", "b.SVGZ"}) {
        const auto map = readMap(folder / name, {});
        EXPECT_EQ(map.format, "SVG");
        EXPECT_THAT(test::ends(map.walls.at(0)), test::near({0, 0, 3, 0}, 1e-9)) << name;
    }
}

TEST(SvgFile, unreadableOneIsNamed) {
    const TemporaryFolder folder;
    writeFile(folder / "empty.svg", "");
    writeFile(folder / "broken.svgz", offmap::test::gzipped(test::inSvg("<g/>")).substr(0, 40));
    EXPECT_THAT(errorOfFile(folder / "none.svg"), HasSubstr("none.svg: cannot be read"));
    std::filesystem::create_directory(folder / "folder.svg");
    EXPECT_THAT(errorOfFile(folder / "folder.svg"), HasSubstr("folder.svg: is a folder"));
    EXPECT_THAT(errorOfFile(folder / "empty.svg"), HasSubstr("empty.svg: the file is empty"));
    EXPECT_THAT(errorOfFile(folder / "broken.svgz"), HasSubstr("broken.svgz"));
}

// shop.svg is of Inkscape 1.2.2: a shop of 8 m x 5 m at 1:100, with an inner wall and its door, a
// bay of 1.5 m radius, a column of 80 cm and two desks.
TEST(SvgFile, planOfInkscapeAtItsScale) {
    MapOptions options;
    options.scale = 100;
    const auto map = readMap(offmap::test::sourceFile("tests/maps/shop.svg"), options);
    EXPECT_EQ(layerOf(map, "Walls").lines, 12U);  // 4 + 2 walls, 2 + 4 quarters of circles
    // The sheet is 29.7 m high, the walls begin 2 m below its upper edge and 1 m from its left one.
    EXPECT_THAT(test::ends(map.walls.at(0)), test::near({1, 27.7, 9, 27.7}, 1e-9));
    // lengths: the rectangle, both parts of the inner wall, half a circle and a whole one
    EXPECT_NEAR(layerOf(map, "Walls").length, 26 + 4 + 1.5 * M_PI + 0.8 * M_PI, 1e-9);
    EXPECT_THAT(map.notes, testing::Contains("left out: 1 text"));
    EXPECT_GT(layerOf(map, "Furniture").walls, 8U);
    // On paper only the rectangle and its bay are longer than 5 cm.
    EXPECT_THAT(readMap(offmap::test::sourceFile("tests/maps/shop.svg"), {}).warnings,
                testing::Contains(HasSubstr("--map-scale 100")));
}

TEST(SvgFile, planOnPaperOfShortLinesAloneIsRefused) {
    const TemporaryFolder folder;
    writeFile(folder / "small.svg",
              "<svg width='200mm' height='200mm' viewBox='0 0 200 200'>"
              "<path d='M0 0h20M0 50h30'/></svg>");
    MapOptions options;
    options.minLength = 0.05;
    EXPECT_THAT(errorOfFile(folder / "small.svg", options),
                AllOf(HasSubstr("all of its 2 lines are shorter"), HasSubstr("--map-scale 100")));
    options.scale = 100;
    EXPECT_EQ(errorOfFile(folder / "small.svg", options), "no error");
}

TEST(SvgFile, cleaningIsTold) {
    const TemporaryFolder folder;
    writeFile(folder / "dirty.svg",
              test::inSvg("<g id='a'><path d='M0 1h3M1 1h3M5 5h.01'/></g><path d='M0 1h3'/>"));
    MapOptions options;
    options.minLength = 0.05;
    const auto map = readMap(folder / "dirty.svg", options);
    EXPECT_EQ(map.walls.size(), 2U) << "one a layer";
    EXPECT_THAT(map.notes,
                testing::IsSupersetOf({"merged 1 duplicate, overlapping or touching line",
                                       "dropped 1 line shorter than 0.05 m "
                                       "(map.min_length_m)"}));
}

TEST(LayerRules, setSigmaHeightAndPresence) {
    const TemporaryFolder folder;
    writeFile(
        folder / "a.svg",
        test::inSvg("<g id='COUNTER'><path d='M0 1h3'/></g><g id='door1'><path d='M0 2h1'/></g>"
                    "<g id='walls' data-z-max-m='2.5'><path d='M0 3h1'/></g>"));
    MapOptions options;
    options.rules = {{"counter", 0.05, 0.0, 1.0, true}, {"door*", {}, {}, {}, false}};
    const auto map = readMap(folder / "a.svg", options);
    ASSERT_EQ(map.walls.size(), 2U);
    EXPECT_EQ(map.walls[0].sigma, 0.05);
    EXPECT_EQ(map.walls[0].height, core::Interval(0, 1));
    EXPECT_EQ(map.walls[1].sigma, options.sigma);
    EXPECT_FALSE(layerOf(map, "door1").used);
    EXPECT_THAT(map.warnings, testing::IsEmpty());

    options.rules = {{"Bench", {}, {}, 1.0, true}};
    EXPECT_THAT(readMap(folder / "a.svg", options).warnings,
                testing::ElementsAre(AllOf(HasSubstr("layers.Bench fits no layer"),
                                           HasSubstr("COUNTER, door1, walls"))));
    options.rules = {{"walls", {}, 3.0, {}, true}};
    EXPECT_THAT(errorOfFile(folder / "a.svg", options),
                AllOf(HasSubstr("layers.walls"), HasSubstr("from z 3 up to 2.5")));
}

}  // namespace offmap::maps
