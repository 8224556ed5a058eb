// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateFixture.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/TextMap.h>

#include <algorithm>

namespace offmap::test {

using testing::AllOf;
using testing::HasSubstr;

namespace {

class MapFromLog : public SimulateFixture {
 protected:
    Arguments fromLog(const Arguments& logs, const Arguments& more = {}) const {
        Arguments all{"map", "from-log", "-o", map_};
        all.insert(all.end(), logs.begin(), logs.end());
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    /// Returns that a map takes out of a log.
    uint64_t removedWith(const Path& map, const Path& log) const {
        const Path report = folder_ / "report.json";
        const RunResult run = runOffmap({"reduce", log, "--map", map, "-o", folder_ / "out.rawlog",
                                         "--report", report, "--force", "--quiet"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto totals = json(report).at("totals");
        uint64_t removed = 0;
        for (const auto& [key, value] : totals.items()) {
            if (key.starts_with("points_removed_")) removed += value.get<uint64_t>();
        }
        return removed;
    }

    Path map_ = folder_ / "made.lines";
};

}  // namespace

TEST_F(MapFromLog, roomIsDrawnAsItIs) {
    simulate("random_room",
             {"--scans", "20", "--seed", "2", "--pose-sigma", "0.02,0.3", "--map-error", "0"});
    const RunResult run = runOffmap(fromLog({sim_ / "scans.rawlog"}));
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_EQ(run.err, "");
    const auto made = maps::readTextMap(map_, 0), truth = maps::readTextMap(sim_ / "map.lines", 0);
    // The mean of 20 poses is off by 0.3 degrees / sqrt(20) = 0.07 degrees and 0.5 cm: at 6 m from
    // the robot, three sigmas are 3 hypot(0.7, 0.5) cm = 2.6 cm. 5 cm are asked for.
    constexpr double near = 0.05;  // [m]
    const auto share = [](const std::vector<core::Wall>& of, const std::vector<core::Wall>& in) {
        double all = 0, within = 0;
        for (const core::Wall& wall : of) {
            for (double at = 0.005; at < 1; at += 0.01) {
                const auto place = placeAt(wall, at);
                const auto distance = [&](const core::Wall& w) { return distanceTo(w, place); };
                const double least = distance(*std::ranges::min_element(in, {}, distance));
                all += lengthOf(wall);
                within += least <= near ? lengthOf(wall) : 0;
            }
        }
        return within / all;
    };
    EXPECT_GE(share(truth, made), 0.9);
    EXPECT_GE(share(made, truth), 0.95);
}

TEST_F(MapFromLog, reducesAboutAsWellAsTheTrueMap) {
    simulate("office_room", {"--scans", "10", "--class", "velodyne", "--scanner", "vlp16"});
    const Path log = sim_ / "scans.rawlog";
    const RunResult run = runOffmap(fromLog({log}, {"--config", "vlp16"}));
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_GT(removedWith(map_, log),
              0.95 * static_cast<double>(removedWith(sim_ / "map.lines", log)));
}

TEST_F(MapFromLog, realOfficeIsReducedByItsOwnMapAsByTheDrawnOne) {
    OFFMAP_NEEDS_SHARED_DATA()
    const Path first = sharedData("room/room1.rawlog"), second = sharedData("room/room2.rawlog");
    const RunResult run = runOffmap(fromLog({first, second}));
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    for (const Path& log : {first, second}) {
        EXPECT_GE(removedWith(map_, log),
                  0.98 * static_cast<double>(removedWith(sharedData("room/room.lines"), log)));
    }
}

TEST_F(MapFromLog, otherFormatsHoldTheSameWalls) {
    simulate("office_room", {"--scans", "3"});
    const Path log = sim_ / "scans.rawlog";
    ASSERT_EQ(runOffmap(fromLog({log})).exitCode, 0);
    const auto byText = static_cast<double>(removedWith(map_, log));
    for (const char* name : {"made.dxf", "made.geojson", "made.svg"}) {
        const RunResult run = runOffmap({"map", "from-log", log, "-o", folder_ / name});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        // DXF has no place for sigma: its walls get the default of 0.03 m instead of 0.02 m.
        EXPECT_NEAR(static_cast<double>(removedWith(folder_ / name, log)), byText, 0.02 * byText);
    }
    EXPECT_EQ(runOffmap({"map", "from-log", log, "-o", folder_ / "made.doc"}).exitCode, 1);
}

TEST_F(MapFromLog, existingMapStays) {
    simulate("office_room", {"--scans", "2"});
    writeFile(map_, "mine");
    EXPECT_EQ(runOffmap(fromLog({sim_ / "scans.rawlog"})).exitCode, 2);
    EXPECT_EQ(readFile(map_), "mine");
    EXPECT_EQ(runOffmap(fromLog({sim_ / "scans.rawlog"}, {"--force"})).exitCode, 0);
}

TEST_F(MapFromLog, withoutPosesTheMessageNamesTheOptions) {
    const Observations log = [] {
        SimulatedRobot robot;
        return Observations{robot.cloud()};
    }();
    writeLog(folder_ / "bare.rawlog", log);
    const RunResult run = runOffmap(fromLog({folder_ / "bare.rawlog"}));
    EXPECT_NE(run.exitCode, 0);
    EXPECT_THAT(run.err,
                AllOf(HasSubstr("bare.rawlog"), HasSubstr("--trajectory"), HasSubstr("--pose")));
    EXPECT_FALSE(std::filesystem::exists(map_));
    const RunResult told = runOffmap(fromLog({folder_ / "bare.rawlog"}, {"--pose", "0,0,0"}));
    EXPECT_EQ(told.exitCode, 0) << testing::PrintToString(told);
    EXPECT_TRUE(std::filesystem::exists(map_));
}

TEST_F(MapFromLog, nothingToDrawIsSaid) {
    simulate("office_room", {"--scans", "2"});
    const RunResult run = runOffmap(fromLog({sim_ / "scans.rawlog"}, {"--min-length", "500"}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, AllOf(HasSubstr("no wall of 500 m"), HasSubstr("--min-length")));
    EXPECT_EQ(runOffmap(fromLog({sim_ / "scans.rawlog"}, {"--min-length", "nan"})).exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(map_));
}

}  // namespace offmap::test
