// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateFixture.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/TextMapWriter.h>

#include <algorithm>
#include <cmath>

namespace offmap::test {

using testing::AllOf;
using testing::HasSubstr;

namespace {

/// The rows of a CSV file without quotes, by the names of its columns.
std::vector<std::map<std::string, std::string>> rowsOf(const std::filesystem::path& file) {
    const auto fieldsOf = [](const std::string& line) {
        std::vector<std::string> fields(1);
        for (const char c : line) {
            if (c == ',') {
                fields.emplace_back();
            } else {
                fields.back() += c;
            }
        }
        return fields;
    };
    std::istringstream lines(readFile(file));
    std::string line;
    std::getline(lines, line);
    const auto names = fieldsOf(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(lines, line)) {
        const auto fields = fieldsOf(line);
        EXPECT_EQ(fields.size(), names.size()) << line;
        auto& row = rows.emplace_back();
        for (size_t i = 0; i < std::min(fields.size(), names.size()); ++i) {
            row[names[i]] = fields[i];
        }
    }
    return rows;
}

double number(const std::map<std::string, std::string>& row, const std::string& name) {
    return std::stod(row.at(name));
}

class MapCheck : public SimulateFixture {
 protected:
    Arguments checkArguments(const Arguments& logs, const Path& map,
                             const Arguments& more = {}) const {
        Arguments all{"map", "check", "--map", map, "-o", csv_};
        all.insert(all.end(), logs.begin(), logs.end());
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    RunResult check(const Arguments& logs, const Path& map, const Arguments& more = {}) const {
        const RunResult run = runOffmap(checkArguments(logs, map, more));
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return run;
    }

    Path csv_ = folder_ / "check.csv", profile_ = folder_ / "profile.csv";
};

class MapCheckOfOffice : public MapCheck {
 protected:
    void SetUp() override { OFFMAP_NEEDS_SHARED_DATA() }

    const Arguments logs_{sharedData("room/room1.rawlog"), sharedData("room/room2.rawlog")};
    const Path map_ = sharedData("room/room.lines");
};

}  // namespace

TEST_F(MapCheckOfOffice, bendOfTheWestWallShows) {
    check(logs_, map_, {"--profile", profile_});
    // Wall 0 is the west wall; it runs upwards, and is seen from its right, x > -2.57. In both
    // scans it stands 1 to 2 cm behind the drawn line in its middle, 2 to 4 cm in front further up.
    double middle = 0, upper = 0;
    int middleBins = 0, upperBins = 0;
    for (const auto& row : rowsOf(profile_)) {
        if (row.at("wall") != "0" || row.at("state") != "seen") continue;
        const double y = number(row, "y_m");
        if (y > 0.1 && y < 1.5) middle += number(row, "mean_m"), ++middleBins;
        if (y > 1.6 && y < 2.8) upper += number(row, "mean_m"), ++upperBins;
    }
    ASSERT_GE(middleBins, 4);
    ASSERT_GE(upperBins, 4);
    EXPECT_GT(middle / middleBins - upper / upperBins, 0.03);
    EXPECT_LT(middle / middleBins - upper / upperBins, 0.07);
}

TEST_F(MapCheckOfOffice, summaryNamesTheWorstWalls) {
    const RunResult run = check(logs_, map_);
    EXPECT_THAT(run.out, AllOf(HasSubstr("2 of 2 logs, 2 used"), HasSubstr("11 of 12 seen"),
                               HasSubstr("worst     rms 0.04"), HasSubstr("not seen")));
    EXPECT_EQ(run.err, "");
}

TEST_F(MapCheckOfOffice, picturesAreWritten) {
    for (const char* name : {"plan.svg", "plan.png"}) {
        check(logs_, map_, {"--svg", folder_ / name, "--force"});
        EXPECT_GT(std::filesystem::file_size(folder_ / name), 10'000U);
    }
    EXPECT_THAT(readFile(folder_ / "plan.svg"), HasSubstr("<svg"));
    EXPECT_EQ(readFile(folder_ / "plan.png").substr(1, 3), "PNG");
}

TEST_F(MapCheckOfOffice, jsonTellsWhatTheCsvTells) {
    const RunResult run = check(logs_, map_, {"--json"});
    const auto json = nlohmann::json::parse(run.out);
    const auto rows = rowsOf(csv_);
    ASSERT_EQ(json.at("walls").size(), rows.size());
    EXPECT_EQ(json.at("scans"), 2);
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto& wall = json["walls"][i];
        EXPECT_EQ(wall.at("state"), rows[i].at("state"));
        EXPECT_NEAR(wall.at("seen_share"), number(rows[i], "seen_share"), 1e-4);
        if (wall.contains("mean_m")) {
            EXPECT_NEAR(wall.at("mean_m"), number(rows[i], "mean_m"), 1e-4);
        }
    }
}

TEST_F(MapCheck, wallDrawnOffIsFoundOff) {
    simulate("office_room", {"--scans", "8", "--pose-sigma", "0.01,0.2", "--map-error", "0"});
    auto walls = maps::readTextMap(sim_ / "map.lines", 0.03);
    const Path moved = folder_ / "moved.lines";
    // The wall that the robot sees best: the left one, x = 0, drawn 12 cm outside.
    const auto left = std::ranges::find_if(walls, [](const core::Wall& wall) {
        return std::abs(wall.line.point1.x) < 0.1 && std::abs(wall.line.point2.x) < 0.1;
    });
    ASSERT_NE(left, walls.end());
    left->line.point1.x -= 0.12;
    left->line.point2.x -= 0.12;
    writeFile(moved, maps::textMapOf(walls));
    check({sim_ / "scans.rawlog"}, moved);
    const auto rows = rowsOf(csv_);
    ASSERT_EQ(rows.size(), walls.size());
    for (size_t i = 0; i < rows.size(); ++i) {
        const double expected = static_cast<std::ptrdiff_t>(i) == left - walls.begin() ? -0.12 : 0;
        // Aligned to the walls that are right, a scan's pose is good to some millimetres; a
        // tenth of the 12 cm is what it may give way to the one that is wrong.
        EXPECT_NEAR(number(rows[i], "mean_m"), expected, 0.012) << "wall " << i;
    }
}

TEST_F(MapCheck, wallThatIsNotThereIsMissing) {
    simulate("office_room", {"--scans", "12"});
    auto walls = maps::readTextMap(sim_ / "map.lines", 0.03);
    walls.push_back({.line = {{1, 1}, {1, 2}}});
    walls.push_back({.line = {{50, 2}, {51, 2}}});
    const Path more = folder_ / "more.lines";
    writeFile(more, maps::textMapOf(walls));
    const RunResult run = check({sim_ / "scans.rawlog"}, more);
    const auto rows = rowsOf(csv_);
    EXPECT_EQ(rows.at(rows.size() - 2).at("state"), "missing");
    EXPECT_EQ(rows.back().at("state"), "out_of_view");
    EXPECT_EQ(rows.back().at("mean_m"), "");
    EXPECT_THAT(run.out, AllOf(HasSubstr("looked through"), HasSubstr("out of view")));
}

TEST_F(MapCheck, mapOfAnotherPlaceIsRefusedNotReported) {
    simulate("office_room", {"--scans", "2"});
    const Path away = folder_ / "away.lines";
    writeFile(away, "900 900 904 900\n904 900 904 907\n");
    const RunResult run = runOffmap(checkArguments({sim_ / "scans.rawlog"}, away));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, AllOf(HasSubstr("2 scans none fits"), HasSubstr("--map-origin")));
    EXPECT_FALSE(std::filesystem::exists(csv_));
}

TEST_F(MapCheck, wrongCommandLinesAreRefused) {
    simulate("office_room", {"--scans", "1"});
    const Path log = sim_ / "scans.rawlog", map = sim_ / "map.lines";
    const auto refused = [&](const Arguments& more) {
        const RunResult run = runOffmap(checkArguments({log}, map, more));
        EXPECT_FALSE(std::filesystem::exists(csv_));
        return run;
    };
    EXPECT_EQ(refused({"--svg", folder_ / "plan.jpg"}).exitCode, 1);
    EXPECT_EQ(refused({"--gate", "nan"}).exitCode, 1);
    EXPECT_EQ(refused({"--bin", "0"}).exitCode, 1);
    EXPECT_EQ(refused({"--profile", csv_}).exitCode, 1) << "two outputs of one name";
    writeFile(csv_, "mine");
    EXPECT_EQ(runOffmap(checkArguments({log}, map)).exitCode, 2) << "it exists already";
    EXPECT_EQ(readFile(csv_), "mine");
}

TEST_F(MapCheck, damagedLogIsNamed) {
    simulate("office_room", {"--scans", "2"});
    const Path broken = folder_ / "broken.rawlog";
    const std::string whole = readFile(sim_ / "scans.rawlog");
    writeFile(broken, whole.substr(0, whole.size() / 2));
    const RunResult run =
        runOffmap(checkArguments({sim_ / "scans.rawlog", broken}, sim_ / "map.lines"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("broken.rawlog"));
    EXPECT_FALSE(std::filesystem::exists(csv_));
}

}  // namespace offmap::test
