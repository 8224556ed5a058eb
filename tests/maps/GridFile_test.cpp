// SPDX-License-Identifier: BSD-3-Clause
#include "../support/GridTraversal.h"
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/core/LineMap.h>
#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/GridFile.h>
#include <offmap/maps/GridWriter.h>
#include <offmap/maps/MapFile.h>
#include <offmap/maps/Specks.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;
using testing::HasSubstr;

const std::filesystem::path malaga =
    "/usr/share/mrpt/datasets/2006-MalagaCampus.gridmap.gz";  // of the package mrpt-common

class GridFile : public testing::Test {
 protected:
    std::string refusal(const std::string& bytes) const {
        test::writeFile(file_, bytes);
        try {
            readMap(file_, {});
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), testing::StartsWith(file_.string()));
            return error.what();
        }
        return "none";
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "room.gridmap";
    std::string bytes_ = gridMapBytes(test::gridFromText({"......", ".####.", " .... "}));
};

TEST_F(GridFile, readsWhatIsWritten) {
    OccupancyGrid grid = test::gridFromText({"..#...", ".####.", " .... "});
    grid.resolution = 0.05;
    grid.origin = {-1.5, 2.25, 0};
    for (const bool zipped : {false, true}) {
        const std::string bytes = gridMapBytes(grid);
        test::writeFile(file_, zipped ? test::gzipped(bytes) : bytes);
        const OccupancyGrid read = readGridMap(file_);
        EXPECT_EQ(read.width, 6);
        EXPECT_EQ(read.height, 3);
        EXPECT_EQ(read.resolution, 0.05);
        EXPECT_EQ(read.origin.x(), -1.5);
        EXPECT_EQ(read.origin.y(), 2.25);
        EXPECT_EQ(read.cells, grid.cells);
    }
}

TEST_F(GridFile, isAMapOfLines) {
    test::writeFile(file_, bytes_);
    const MapOfFile map = readMap(file_, {});
    EXPECT_EQ(map.format, "grid map");
    ASSERT_EQ(map.walls.size(), 1U);
    EXPECT_THAT(map.notes, testing::Contains("grid: 6 x 3 cells of 1 m"));
}

TEST_F(GridFile, cutAnywhereIsRefused) {
    // 80 bytes: a header of 62 and 18 cells.
    for (const size_t size : {0UL, 1UL, 20UL, 40UL, 55UL, 70UL, 79UL}) {
        ASSERT_LT(size, bytes_.size());
        EXPECT_THAT(refusal(bytes_.substr(0, size)), HasSubstr("room.gridmap: is ")) << size;
    }
    const std::string zipped = test::gzipped(bytes_);
    EXPECT_THAT(refusal(zipped.substr(0, zipped.size() - 12)), HasSubstr("damaged"));
}

TEST_F(GridFile, wrongChecksumIsRefused) {
    std::string zipped = test::gzipped(bytes_);
    zipped[zipped.size() - 6] ^= 1;
    EXPECT_THAT(refusal(zipped), HasSubstr("damaged"));
}

TEST_F(GridFile, damagedHeaderIsRefused) {
    // length and name of the class, version, bits, width, height, x min, x max, y min, y max, cell
    const size_t version = 32, bits = 33, width = 34, corner = 42, resolution = 58;
    const auto with = [&](size_t place, const auto& value) {
        std::string bytes = bytes_;
        std::memcpy(bytes.data() + place, &value, sizeof value);
        return refusal(bytes);
    };
    EXPECT_THAT(with(3, 'x'), HasSubstr("no MRPT occupancy grid"));
    EXPECT_THAT(with(version, uint8_t{2}), HasSubstr("version 2"));
    EXPECT_THAT(with(bits, uint8_t{16}), HasSubstr("16 bits"));
    EXPECT_THAT(with(width, uint32_t{0x7fffffff}), HasSubstr("do not fill"));
    EXPECT_THAT(with(corner, std::nanf("")), HasSubstr("corner of the grid at nan"));
    EXPECT_THAT(with(corner, 3e30F), HasSubstr("corner of the grid at"));
    EXPECT_THAT(with(resolution, 0.0F), HasSubstr("do not fill"));
    EXPECT_THAT(with(resolution, -1.0F), HasSubstr("do not fill"));
}

TEST_F(GridFile, absurdSizeIsRefused) {
    std::string bytes = bytes_;
    const uint32_t side = 1'000'000;
    const float length = 1'000'000;
    std::memcpy(bytes.data() + 34, &side, sizeof side);
    std::memcpy(bytes.data() + 46, &length, sizeof length);
    std::memcpy(bytes.data() + 38, &side, sizeof side);
    std::memcpy(bytes.data() + 54, &length, sizeof length);
    EXPECT_THAT(refusal(bytes), HasSubstr("more than 100000000"));
}

TEST_F(GridFile, missingFileIsTold) {
    std::string message;
    try {
        readGridMap(folder_ / "none.gridmap");
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    EXPECT_THAT(message, HasSubstr("none.gridmap: cannot read"));
}

TEST_F(GridFile, unusedResolutionIsWarnedOf) {
    test::writeFile(file_, bytes_);
    MapOptions options;
    options.resolution = 0.1;
    EXPECT_THAT(readMap(file_, options).warnings, testing::Contains(HasSubstr("--map-resolution")));
}

TEST(MalagaGrid, cellsAreThoseOfMrpt) {
    const OccupancyGrid grid = readGridMap(malaga);
    mrpt::io::CFileGZInputStream in(malaga.string());
    auto archive = mrpt::serialization::archiveFrom(in);
    mrpt::maps::COccupancyGridMap2D expected;
    archive >> expected;
    ASSERT_EQ(static_cast<unsigned>(grid.width), expected.getSizeX());
    ASSERT_EQ(static_cast<unsigned>(grid.height), expected.getSizeY());
    EXPECT_NEAR(grid.resolution, expected.getResolution(), 1e-8);
    EXPECT_EQ(grid.origin.x(), expected.getXMin());
    EXPECT_EQ(grid.origin.y(), expected.getYMin());
    size_t different = 0;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const float free = expected.getCell(x, y);
            const Cell cell = free < 0.4F   ? Cell::Occupied
                              : free > 0.6F ? Cell::Free
                                            : Cell::Unknown;
            different += cell != grid.at(x, y);
        }
    }
    EXPECT_EQ(different, 0U);
}

/// Distances in cells.
struct Malaga : public testing::Test {
    OccupancyGrid grid = [] {
        OccupancyGrid read = readGridMap(malaga);
        read.resolution = 1;
        read.origin = {};
        return read;
    }();
    Drawing drawing = drawingOf(grid, {}, "grid map", "malaga");
    core::LineMap map{drawing.walls};

    /// From the cell's border, which is half a cell from its middle at least.
    bool hasWallWithinACell(int x, int y) const {
        return map.nearestWall({x + 0.5, y + 0.5}, 1.5, 0).has_value();
    }
    double distanceToOccupied(const TPoint2D& place) const {
        const int x = static_cast<int>(std::floor(place.x)),
                  y = static_cast<int>(std::floor(place.y));
        double least = 100;
        for (int v = y - 2; v <= y + 2; ++v) {
            for (int u = x - 2; u <= x + 2; ++u) {
                if (grid.at(u, v) != Cell::Occupied) continue;
                const double dx = std::max({u - place.x, place.x - u - 1, 0.0});
                const double dy = std::max({v - place.y, place.y - v - 1, 0.0});
                least = std::min(least, std::hypot(dx, dy));
            }
        }
        return least;
    }
    bool bordersFree(int x, int y) const {
        return grid.at(x + 1, y) == Cell::Free || grid.at(x - 1, y) == Cell::Free ||
               grid.at(x, y + 1) == Cell::Free || grid.at(x, y - 1) == Cell::Free;
    }
};

TEST_F(Malaga, wallsStayWithinACellOfOccupiedOnes) {
    double worst = 0;
    for (const core::Wall& wall : map.walls()) {
        const double length = wall.line.length();
        for (double at = 0; at <= length; at += 0.25) {
            const TPoint2D place =
                wall.line.point1 + (wall.line.point2 - wall.line.point1) * (at / length);
            worst = std::max(worst, distanceToOccupied(place));
        }
    }
    EXPECT_LE(worst, 1);
}

TEST_F(Malaga, occupiedCellsThatCanBeSeenHaveAWallWithinACell) {
    OccupancyGrid withoutSpecks = grid;
    constexpr size_t leastCells = 4;
    EXPECT_GT(dropSpecks(withoutSpecks, leastCells), 0U);
    size_t seen = 0, far = 0, specks = 0;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            if (grid.at(x, y) != Cell::Occupied || !bordersFree(x, y)) continue;
            ++seen;
            const bool isSpeck = withoutSpecks.at(x, y) != Cell::Occupied;
            specks += isSpeck;
            far += !isSpeck && !hasWallWithinACell(x, y);
        }
    }
    EXPECT_EQ(far, 0U);
    EXPECT_LT(specks, seen / 10);
    EXPECT_LT(map.walls().size(), seen / 2) << "of the cells that are seen";
}

}  // namespace

}  // namespace offmap::maps
