// SPDX-License-Identifier: BSD-3-Clause
#include "../support/PngMaker.h"
#include "../support/TemporaryFolder.h"

#include <offmap/maps/MapFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace offmap::maps {

namespace {

using test::makePng;
using testing::HasSubstr;
using namespace std::string_literals;

const char black = 0, white = static_cast<char>(255);

/// A plan of 6 x 4 pixels: a wall of two rows at the top. Each pixel is one of the two strings.
std::string plan(const std::string& dark, const std::string& light) {
    std::string rows;
    for (int i = 0; i < 12; ++i) rows += dark;
    for (int i = 0; i < 12; ++i) rows += light;
    return rows;
}

class MapPicture : public testing::Test {
 protected:
    MapOfFile read(const std::string& bytes, const std::string& name = "plan.png") const {
        test::writeFile(folder_ / name, bytes);
        MapOptions options;
        options.resolution = 0.5;
        return readMap(folder_ / name, options);
    }

    /// The face of the wall: it is 1 m thick from y = 1 m, and 3 m long.
    void expectPlan(const MapOfFile& map) const {
        ASSERT_EQ(map.walls.size(), 1U);
        const auto& line = map.walls[0].line;
        EXPECT_DOUBLE_EQ(line.point1.y, 1);
        EXPECT_DOUBLE_EQ(line.point2.y, 1);
        EXPECT_NEAR(line.length(), 3, 1e-9);
        EXPECT_THAT(map.warnings, testing::IsEmpty());
    }

    std::string refusal(const std::string& bytes, const std::string& name = "plan.png") const {
        try {
            read(bytes, name);
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), testing::StartsWith((folder_ / name).string()));
            return error.what();
        }
        return "none";
    }

    test::TemporaryFolder folder_;
};

TEST_F(MapPicture, darkIsAWall) {
    expectPlan(read(makePng({6, 4}, plan(std::string(1, black), std::string(1, white)))));
    const auto grey = [](int value) { return std::string(1, static_cast<char>(value)); };
    expectPlan(read(makePng({6, 4}, plan(grey(127), grey(128)))));
}

TEST_F(MapPicture, everyKindOfPixelIsRead) {
    const std::string dark16 = "\x10\x00"s, light16 = "\xf0\x00"s;
    expectPlan(read(makePng({6, 4, 16}, plan(dark16, light16))));
    expectPlan(read(makePng({6, 4, 8, 2}, plan("\x20\x00\x40"s, "\xff\xf0\xe0"s))));
    expectPlan(read(makePng({6, 4, 8, 4}, plan("\x00\xff"s, "\xff\xff"s))));
    expectPlan(read(makePng({6, 4, 8, 6}, plan("\x20\x00\x40\xff"s, "\xff\xf0\xe0\xff"s))));
    const std::string palette = "\xff\xff\xff\x80\x00\x00"s;  // the dark colour is number 1
    expectPlan(read(makePng({6, 4, 8, 3, palette}, plan("\x01"s, "\x00"s))));
    // One bit a pixel, a byte a row.
    expectPlan(read(makePng({6, 4, 1}, "\x00\x00\xfc\xfc"s)));
}

TEST_F(MapPicture, transparentIsUnknown) {
    // Below the wall nothing is known, so that its lower face cannot be seen.
    const std::string none = "\x00\x00"s, dark = "\x00\xff"s, light = "\xff\xff"s;
    std::string rows;
    for (const std::string& row : {light, dark, none, none, none}) {
        for (int i = 0; i < 6; ++i) rows += row;
    }
    const MapOfFile map = read(makePng({6, 5, 8, 4}, rows));
    ASSERT_EQ(map.walls.size(), 1U);
    EXPECT_DOUBLE_EQ(map.walls[0].line.point1.y, 1.75) << "the middle of a wall of one pixel";
    const std::string palette = "\xff\xff\xff\x00\x00\x00\x00\x00\x00"s, opacity = "\xff\xff\x00"s;
    rows = std::string(6, 0) + std::string(6, 1) + std::string(18, 2);
    EXPECT_EQ(read(makePng({6, 5, 8, 3, palette, opacity}, rows)).walls.size(), 1U);
}

TEST_F(MapPicture, netpbmIsRead) {
    const std::string pixels = plan(std::string(1, black), std::string(1, white));
    expectPlan(read("P5\n# a plan\n6 4\n255\n" + pixels, "plan.pgm"));
    expectPlan(read("P5 6 4 15\n" + plan("\x01", "\x0f"), "plan.pgm"));
    expectPlan(read("P5 6 4 65535\n" + plan("\x01\x00"s, "\xff\x00"s), "plan.PGM"));
    expectPlan(read("P6 6 4 255\n" + plan("\x01\x02\x03", "\xff\xff\xff"), "plan.ppm"));
}

TEST_F(MapPicture, damagedNetpbmIsRefused) {
    const std::string pixels = plan(std::string(1, black), std::string(1, white));
    EXPECT_THAT(refusal("P5 6 4 255\n" + pixels.substr(1), "plan.pgm"), HasSubstr("cut off"));
    EXPECT_THAT(refusal("P5 999999999 999999999 255\n" + pixels, "plan.pgm"), HasSubstr("cut off"));
    EXPECT_THAT(refusal("P2 6 4 255\n0 0 0", "plan.pgm"), HasSubstr("binary PGM"));
    EXPECT_THAT(refusal("P5 6 4", "plan.pgm"), HasSubstr("header"));
    EXPECT_THAT(refusal("P5 6 4 0\n" + pixels, "plan.pgm"), HasSubstr("white is 0"));
    EXPECT_THAT(refusal("P5 0 4 255\n" + pixels, "plan.pgm"), HasSubstr("plan.pgm: "));
}

TEST_F(MapPicture, damagedPngIsRefused) {
    const std::string png = makePng({6, 4}, plan(std::string(1, black), std::string(1, white)));
    EXPECT_THAT(refusal(png.substr(0, 20)), HasSubstr("plan.png: "));
    EXPECT_THAT(refusal(png.substr(0, png.size() - 20)), HasSubstr("damaged"));
    EXPECT_THAT(refusal("not a picture"), HasSubstr("no picture of a kind that can be read"));
    EXPECT_THAT(refusal(""), HasSubstr("the file is empty"));
}

TEST_F(MapPicture, withoutResolutionIsRefused) {
    test::writeFile(folder_ / "plan.png", makePng({6, 4}, plan("\x00"s, "\xff"s)));
    std::string message;
    try {
        readMap(folder_ / "plan.png", {});
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    EXPECT_THAT(message, HasSubstr("add --map-resolution"));
}

TEST_F(MapPicture, withoutWallIsRefused) {
    EXPECT_THAT(refusal(makePng({6, 4}, std::string(24, white))), HasSubstr("holds no wall"));
}

TEST_F(MapPicture, tooManyPixelsAreRefused) {
    // A row that says it has many: read before any pixel is.
    const std::string png = makePng({20000, 1}, std::string(20000, white));
    std::string many = png;
    many.replace(20, 4, test::bigEndian(20000));
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(many.data() + 12), 17);
    many.replace(29, 4, test::bigEndian(static_cast<uint32_t>(sum)));
    EXPECT_THAT(refusal(many), HasSubstr("20000 x 20000 cells, more than"));
}

TEST_F(MapPicture, missingFileAndFolderAreTold) {
    MapOptions options;
    options.resolution = 0.05;
    std::string message;
    try {
        readMap(folder_ / "none.png", options);
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    EXPECT_THAT(message, HasSubstr("none.png: cannot be read: No such file"));
}

}  // namespace

}  // namespace offmap::maps
