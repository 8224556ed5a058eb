// SPDX-License-Identifier: BSD-3-Clause
#include "../support/PngMaker.h"
#include "ReduceFixture.h"

#include <offmap/core/LineMap.h>
#include <offmap/maps/GridWriter.h>
#include <offmap/maps/RosMapWriter.h>
#include <offmap/maps/TextMap.h>

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace {

using namespace offmap;
using namespace offmap::test;
using mrpt::math::TPoint2D;
using testing::HasSubstr;

/// The office of the real scans, its plan as grids of 5 cm.
class GridMaps : public ReduceFixture {
 protected:
    GridMaps() {
        if (!mayLackSharedData()) plan_ = maps::readTextMap(sharedData("room/room.lines"), 0.03);
    }

    maps::OccupancyGrid grid() const { return maps::gridOf(plan_, 0.05); }

    double removedWith(const Path& map, const Arguments& more = {}) {
        Arguments arguments{"reduce",   sharedData("room/room1.rawlog"), "--map",  map, "-o", out_,
                            "--report", folder_ / "report.json",         "--force"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = runOffmap(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        if (run.exitCode != 0) return 0;
        const auto report = nlohmann::json::parse(readFile(folder_ / "report.json"));
        return report.at("totals").at("points_removed").get<double>();
    }

    /// Removed counts of grids may differ by 3 % from those of the lines they were drawn from.
    void expectLikeTheLines(const Path& map, const Arguments& more = {}) {
        const double lines = removedWith(sharedData("room/room.lines"));
        EXPECT_GT(lines, 10000);
        const double removed = removedWith(map, more);
        EXPECT_NEAR(removed, lines, 0.03 * lines) << map;
        RecordProperty("removed_per_mille", static_cast<int>(std::lround(1000 * removed / lines)));
    }

    /// Where a robot stood in the room, and 2D scans from there with 1 cm of range noise.
    void writeSimpleMap(const Path& file) const {
        const core::LineMap map(plan_);
        std::mt19937 random(1);
        std::normal_distribution<float> noise(0, 0.01F);
        mrpt::maps::CSimpleMap robot;
        for (double x = -2; x < 7.6; x += 0.3) {
            const TPoint2D place{x, 0.8 + 0.3 * std::sin(x)};
            auto scan = mrpt::obs::CObservation2DRangeScan::Create();
            constexpr size_t rays = 720;
            scan->aperture = static_cast<float>(2 * std::numbers::pi * (rays - 1) / rays);
            scan->maxRange = 20;
            scan->resizeScan(rays);
            for (size_t i = 0; i < rays; ++i) {
                const double angle = scan->getScanAngle(i);
                const auto hit = map.castRay(place, {std::cos(angle), std::sin(angle)}, 20, 1);
                scan->setScanRangeValidity(i, hit.has_value());
                scan->setScanRange(i, hit ? static_cast<float>(hit->range) + noise(random) : 0);
            }
            mrpt::obs::CSensoryFrame frame;
            frame.insert(scan);
            mrpt::poses::CPose3DPDFGaussian pose;
            pose.mean = {place.x, place.y, 0, 0, 0, 0};
            robot.insert(pose, frame);
        }
        ASSERT_TRUE(robot.saveToFile(file.string()));
    }

    std::vector<core::Wall> plan_;
};

TEST_F(GridMaps, gridMapReducesLikeItsLines) {
    OFFMAP_NEEDS_SHARED_DATA();
    const Path file = folder_ / "room.gridmap";
    writeFile(file, maps::gridMapBytes(grid()));
    expectLikeTheLines(file);
    expectLikeTheLines(file, {"--map-as", "grid"});
}

TEST_F(GridMaps, rosMapReducesLikeItsLines) {
    OFFMAP_NEEDS_SHARED_DATA();
    writeFile(folder_ / "room.pgm", maps::rosPictureOf(grid()));
    writeFile(folder_ / "room.yaml", maps::rosYamlOf(grid(), "room.pgm"));
    expectLikeTheLines(folder_ / "room.yaml");
}

TEST_F(GridMaps, rosMapThatIsTurnedReducesLikeItsLines) {
    OFFMAP_NEEDS_SHARED_DATA();
    // The plan is drawn as it looks from an origin that is turned, and the yaml says so.
    const mrpt::poses::CPose2D turned(0.4, -0.3, 0.5);
    for (core::Wall& wall : plan_) {
        for (TPoint2D* end : {&wall.line.point1, &wall.line.point2}) {
            *end = turned.inverseComposePoint(*end);
        }
    }
    maps::OccupancyGrid drawn = grid();
    drawn.origin = turned + drawn.origin;
    writeFile(folder_ / "room.pgm", maps::rosPictureOf(drawn));
    writeFile(folder_ / "room.yaml", maps::rosYamlOf(drawn, "room.pgm"));
    expectLikeTheLines(folder_ / "room.yaml");
}

TEST_F(GridMaps, pictureReducesLikeItsLines) {
    OFFMAP_NEEDS_SHARED_DATA();
    const maps::OccupancyGrid drawn = grid();
    std::string pixels;
    for (int y = drawn.height - 1; y >= 0; --y) {
        for (int x = 0; x < drawn.width; ++x) {
            pixels += drawn.at(x, y) == maps::Cell::Occupied ? '\x20' : '\xf8';
        }
    }
    const auto width = static_cast<uint32_t>(drawn.width),
               height = static_cast<uint32_t>(drawn.height);
    writeFile(folder_ / "room.png", makePng({width, height}, pixels));
    expectLikeTheLines(folder_ / "room.png", {"--map-resolution", "0.05", "--map-origin",
                                              std::to_string(drawn.origin.x()) + "," +
                                                  std::to_string(drawn.origin.y()) + ",0"});
}

TEST_F(GridMaps, simpleMapReducesLikeTheLinesItSaw) {
    OFFMAP_NEEDS_SHARED_DATA();
    writeSimpleMap(folder_ / "room.simplemap");
    expectLikeTheLines(folder_ / "room.simplemap");
}

TEST_F(GridMaps, pictureWithoutResolutionNamesTheFix) {
    const Path file = folder_ / "plan.png";
    writeFile(file, makePng({2, 2}, std::string(4, 0)));
    expectRefusal({"map", "info", file}, 2, HasSubstr("--map-resolution"));
}

TEST_F(GridMaps, simpleMapWithoutScansIsRefused) {
    const Path file = folder_ / "empty.simplemap";
    mrpt::maps::CSimpleMap().saveToFile(file.string());
    expectRefusal({"map", "info", file}, 2, HasSubstr("no 2D laser scan"));
    writeFile(file, "nothing of that kind");
    expectRefusal({"map", "info", file}, 2, HasSubstr("no MRPT simple map"));
}

}  // namespace
