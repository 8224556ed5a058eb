// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/maps/MapFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace offmap::maps {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class MapFile : public testing::Test {
 protected:
    std::filesystem::path written(const std::string& name, const std::string& text) const {
        const auto file = folder_ / name;
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    static std::string errorOf(const std::filesystem::path& file) {
        try {
            readMap(file, {});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    }
    test::TemporaryFolder folder_;
};

TEST_F(MapFile, anyTextMayBeATextMap) {
    for (const char* name : {"plan", "plan.lines", "PLAN.TXT", "plan.walls"})
        EXPECT_EQ(readMap(written(name, "0 0 1 0\n"), {}).walls.size(), 1U) << name;
}

TEST_F(MapFile, anUnknownExtensionIsToldWithTheKnownOnes) {
    EXPECT_THAT(errorOf(written("plan.3dm", "\x01\x02")),
                AllOf(HasSubstr("plan.3dm:1:"), HasSubstr(".dxf"), HasSubstr(".gridmap.gz")));
    EXPECT_THAT(errorOf(written("plan.lines", "?")), Not(HasSubstr(".dxf")));
    EXPECT_THAT(errorOf(folder_ / "none.3dm"), Not(HasSubstr(".dxf"))) << "it is not there";
}

TEST_F(MapFile, aFolderIsNoMap) { EXPECT_THAT(errorOf(folder_.path()), HasSubstr("is a folder")); }

TEST_F(MapFile, unitsHoldForTextMapsToo) {
    MapOptions inMillimetres;
    inMillimetres.units = LengthUnit::Millimetre;
    const auto map = readMap(written("plan.lines", "0 0 1500 0 0.02\n"), inMillimetres);
    EXPECT_DOUBLE_EQ(map.walls[0].line.point2.x, 1.5);
    EXPECT_EQ(map.walls[0].sigma, 0.02) << "of the map in metres";
    EXPECT_THAT(map.notes, ElementsAre(HasSubstr("mm, by --map-units")));
}

TEST_F(MapFile, optionsThatMeanNothingAreTold) {
    MapOptions options;
    const auto file = written("plan.lines", "0 0 1 0\n");
    EXPECT_THAT(readMap(file, options).warnings, IsEmpty());
    options.resolution = 0.05;
    options.gridWalls = GridWalls::Cells;
    options.anchor = GeographicPlace{48, 11};
    EXPECT_THAT(readMap(file, options).warnings,
                ElementsAre(HasSubstr("--map-anchor means nothing to text maps"),
                            HasSubstr("--map-resolution"), HasSubstr("--map-as grid")));
}

}  // namespace
}  // namespace offmap::maps
