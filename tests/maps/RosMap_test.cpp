// SPDX-License-Identifier: BSD-3-Clause
#include "../support/GridTraversal.h"
#include "../support/PngMaker.h"
#include "../support/TemporaryFolder.h"

#include <offmap/maps/MapFile.h>
#include <offmap/maps/RosMap.h>
#include <offmap/maps/RosMapWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::maps {

namespace {

using testing::HasSubstr;

constexpr const char* plain =
    "image: map.pgm\nresolution: 0.05\norigin: [-1, 2, 0.5]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string refusal(const std::string& text) {
    try {
        parseRosMap(text, "map.yaml");
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(RosMapYaml, isRead) {
    const RosMapDescription map = parseRosMap(std::string(plain) + "mode: scale\n", "map.yaml");
    EXPECT_EQ(map.image, "map.pgm");
    EXPECT_EQ(map.resolution, 0.05);
    EXPECT_EQ(map.origin.x(), -1);
    EXPECT_EQ(map.origin.y(), 2);
    EXPECT_EQ(map.origin.phi(), 0.5);
    EXPECT_FALSE(map.negate);
    EXPECT_EQ(map.occupied, 0.65);
    EXPECT_EQ(map.free, 0.196);
    EXPECT_EQ(map.mode, RosMapMode::Scale);
    EXPECT_THAT(map.warnings, testing::IsEmpty());
}

TEST(RosMapYaml, thresholdsMayBeMissing) {
    const auto map = parseRosMap("{image: a.png, resolution: 1, origin: [0, 0, 0]}", "map.yaml");
    EXPECT_EQ(map.occupied, 0.65);
    EXPECT_EQ(map.free, 0.25);
}

TEST(RosMapYaml, faultsAreToldWithTheirLine) {
    const auto with = [](const std::string& line) { return refusal(plain + line); };
    EXPECT_THAT(refusal("image: a.pgm\nresolution: five\n"),
                HasSubstr("map.yaml:2: resolution is 'five', not a number"));
    EXPECT_THAT(refusal("image: a.pgm\nresolution: -1\n"), HasSubstr(":2: resolution has to be"));
    EXPECT_THAT(refusal("image: a.pgm\nresolution: nan\n"), HasSubstr(":2: resolution is 'nan'"));
    EXPECT_THAT(refusal("image: [a]\n"), HasSubstr(":1: image is the name"));
    EXPECT_THAT(refusal("origin: [0, 0]\n"), HasSubstr(":1: origin takes three numbers"));
    EXPECT_THAT(refusal("origin: [0, 0, north]\n"), HasSubstr("yaw is 'north'"));
    EXPECT_THAT(refusal("origin: [1e300, 0, 0]\n"), HasSubstr("too far away"));
    EXPECT_THAT(with("mode: colour\n"), HasSubstr(":7: mode is 'colour'"));
    EXPECT_THAT(with("negate: 1\n"), HasSubstr(":7: 'negate' stands here a second time"));
    EXPECT_THAT(refusal("negate: 2\n"), HasSubstr(":1: negate is 0 or 1"));
    EXPECT_THAT(refusal("free_thresh: 20\n"), HasSubstr("between 0 and 1"));
    EXPECT_THAT(refusal("image: a\nresolution: 1\n"), HasSubstr("origin is missing"));
    EXPECT_THAT(refusal("image: a\nresolution: 1\norigin: [0,0,0]\nfree_thresh: 0.9\n"),
                HasSubstr("above occupied_thresh"));
    EXPECT_THAT(refusal("image: [\n"), HasSubstr("map.yaml:"));
    EXPECT_THAT(refusal(""), HasSubstr("no settings"));
    EXPECT_THAT(refusal("- 1\n"), HasSubstr("no settings"));
}

TEST(RosMapYaml, unknownKeyIsWarnedOf) {
    const auto map = parseRosMap(std::string(plain) + "negat: 1\n", "map.yaml");
    EXPECT_THAT(map.warnings, testing::ElementsAre(HasSubstr("line 7: 'negat' is not known")));
}

class RosMap : public testing::Test {
 protected:
    /// Three rows of 5 pixels: the middle one has one brightness, the others have another.
    MapOfFile mapOf(int middle, int around, const std::string& more) const {
        std::string pixels;
        for (const int value : {around, middle, around}) pixels.append(5, static_cast<char>(value));
        test::writeFile(folder_ / "map.pgm", "P5 5 3 255\n" + pixels);
        test::writeFile(yaml_, "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\n" + more);
        return readMap(yaml_, {});
    }
    bool hasWall(int middle, int around, const std::string& more) const {
        try {
            return !mapOf(middle, around, more).walls.empty();
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("holds no wall"));
            return false;
        }
    }

    test::TemporaryFolder folder_;
    std::filesystem::path yaml_ = folder_ / "map.yaml";
};

TEST_F(RosMap, thresholdsTellWhatIsOccupied) {
    const std::string thresholds = "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    EXPECT_TRUE(hasWall(0, 254, thresholds));
    EXPECT_TRUE(hasWall(89, 254, thresholds));   // (255 - 89) / 255 = 0.651
    EXPECT_FALSE(hasWall(90, 254, thresholds));  // 0.647
    EXPECT_TRUE(hasWall(200, 254, "occupied_thresh: 0.2\nfree_thresh: 0.1\n"));
}

TEST_F(RosMap, negateMakesWhiteAWall) {
    EXPECT_TRUE(hasWall(255, 0, "negate: 1\n"));
    EXPECT_FALSE(hasWall(100, 0, "negate: 1\n"));
}

TEST_F(RosMap, rawModeCountsPercent) {
    EXPECT_TRUE(hasWall(100, 0, "mode: raw\n"));
    EXPECT_FALSE(hasWall(255, 0, "mode: raw\n")) << "255 is unknown";
    EXPECT_FALSE(hasWall(50, 0, "mode: raw\n"));
}

TEST_F(RosMap, transparentPixelsAreUnknown) {
    const auto wallWith = [&](char opacity) {
        std::string rows;
        for (const char value : {'\xff', '\0', '\xff'}) {
            for (int i = 0; i < 5; ++i) rows += {value, value == 0 ? opacity : '\xff'};
        }
        test::writeFile(folder_ / "map.png", test::makePng({5, 3, 8, 4}, rows));
        test::writeFile(yaml_, "image: map.png\nresolution: 1\norigin: [0, 0, 0]\nmode: scale\n");
        return readMap(yaml_, {});
    };
    EXPECT_EQ(wallWith('\xff').walls.size(), 1U);
    EXPECT_THROW(wallWith('\0'), std::runtime_error);
}

TEST_F(RosMap, originTurnsAboutTheLowerLeftCorner) {
    OccupancyGrid grid = test::gridFromText({".....", "#####", "....."});
    grid.resolution = 0.5;
    grid.origin = {3, 4, std::numbers::pi / 2};
    test::writeFile(folder_ / "my map.pgm", rosPictureOf(grid));
    test::writeFile(yaml_, rosYamlOf(grid, "my map.pgm"));
    const MapOfFile map = readMap(yaml_, {});
    ASSERT_EQ(map.walls.size(), 1U);
    const auto& line = map.walls[0].line;
    // 6 digits behind the point in the file.
    EXPECT_NEAR(line.point1.x, 3 - 0.75, 1e-6);
    EXPECT_NEAR(line.point2.x, 3 - 0.75, 1e-6);
    EXPECT_NEAR(std::min(line.point1.y, line.point2.y), 4, 1e-6);
    EXPECT_EQ(map.format, "ROS map");
}

TEST_F(RosMap, missingImageNamesBothFiles) {
    test::writeFile(yaml_, plain);
    std::string message;
    try {
        readMap(yaml_, {});
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    EXPECT_THAT(message, HasSubstr("map.yaml: its image: "));
    EXPECT_THAT(message, HasSubstr("map.pgm: cannot be read: No such file"));
}

TEST_F(RosMap, imageMayHaveAnAbsolutePath) {
    test::TemporaryFolder other;
    test::writeFile(other / "m.pgm", "P5 5 3 255\n\xff\xff\xff\xff\xff" + std::string(5, 0) +
                                         "\xff\xff\xff\xff\xff");
    test::writeFile(
        yaml_, "image: " + (other / "m.pgm").string() + "\nresolution: 1\norigin: [0, 0, 0]\n");
    EXPECT_EQ(readMap(yaml_, {}).walls.size(), 1U);
}

TEST_F(RosMap, imageInTheNetIsNotFetched) {
    test::writeFile(yaml_,
                    "image: /vsicurl/http://localhost/m.pgm\nresolution: 1\norigin: [0,0,0]\n");
    EXPECT_THROW(readMap(yaml_, {}), std::runtime_error);
}

}  // namespace

}  // namespace offmap::maps
