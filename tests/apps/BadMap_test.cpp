// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadMap : public ReduceFixture {
 protected:
    BadMap() { writeLog(in_, smallLog()); }

    template <class Matcher>
    void expectRefused(const std::string& content, const Matcher& message) {
        writeFile(map_, content);
        expectRefusal(reduceArguments(), 2, message);
    }
};

TEST_F(BadMap, missingFileIsNamed) {
    std::filesystem::remove(map_);
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr(map_.string()), HasSubstr("No such file or directory")));
}

TEST_F(BadMap, emptyMapIsRefused) {
    for (const char* content : {"", "\n\n", "# walls follow\n"}) {
        expectRefused(content, AllOf(HasSubstr(map_.string()), HasSubstr("holds no wall"),
                                     HasSubstr("x1 y1 x2 y2")));
    }
}

TEST_F(BadMap, badNumberTellsTheLine) {
    expectRefused("0 0 8 0\n8 0 8 five\n",
                  AllOf(HasSubstr(map_.string() + ":2:"), HasSubstr("y2 is 'five', not a number")));
}

TEST_F(BadMap, numberThatIsNotFiniteTellsTheLine) {
    expectRefused("# room\n\n0 nan 8 0\n",
                  AllOf(HasSubstr(map_.string() + ":3:"), HasSubstr("y1 is 'nan', not finite")));
}

TEST_F(BadMap, missingNumberTellsTheLine) {
    expectRefused("0 0 8\n", AllOf(HasSubstr(map_.string() + ":1:"), HasSubstr("3 fields")));
}

TEST_F(BadMap, rawlogIsNoMap) {
    std::filesystem::copy_file(in_, folder_ / "copy.rawlog");
    map_ = folder_ / "copy.rawlog";
    expectRefusal(reduceArguments(), 2, HasSubstr(map_.string()));
}

TEST_F(BadMap, wrongOriginIsRefused) {
    expectRefusal(reduceArguments({"--map-origin", "1,2"}), 1,
                  AllOf(HasSubstr("--map-origin"), HasSubstr("x,y,yaw_deg")));
}

TEST_F(BadMap, mapFarAwayRemovesNothingAndSaysSo) {
    const auto report = folder_ / "report.json";
    const RunResult run = reduce({"--map-origin", "10000,0,0", "--report", report});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("kept whole: 1 no wall in range"));
    EXPECT_THAT(run.err, AllOf(HasSubstr("warning: 1 of 1 scans have no wall within range"),
                               HasSubstr("check --map-origin")));
    const auto json = nlohmann::json::parse(readFile(report));
    EXPECT_EQ(json["totals"]["scans_not_reduced"], (nlohmann::json{{"no_wall_in_range", 1}}));
    EXPECT_EQ(json["totals"]["points_removed"], 0);
    EXPECT_THAT(json["warnings"].dump(), HasSubstr("no wall within range"));
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(entriesOf(out_).at(i).bytes, entriesOf(in_).at(i).bytes);
    }
    EXPECT_EQ(reduce({"--map-origin", "10000,0,0", "--strict", "--force"}).exitCode, 3);
}

// The map is drawn in another frame, turned by 90 degrees and shifted.
TEST_F(BadMap, originPutsTheMapRight) {
    std::string turned;
    for (const offmap::core::Wall& wall : mapOf(offmap::evaluation::officeRoom())) {
        for (const auto& point : {wall.line.point1, wall.line.point2}) {
            turned += std::to_string(point.y - 100) + " " + std::to_string(-(point.x - 50)) + " ";
        }
        turned += "0.02\n";
    }
    ASSERT_EQ(reduce().exitCode, 0);
    const std::string asDrawn = readFile(out_);
    writeFile(map_, turned);
    const auto report = folder_ / "report.json";
    EXPECT_EQ(reduce({"--force", "--map-origin", "50,100,90", "--report", report}).exitCode, 0);
    const auto totals = nlohmann::json::parse(readFile(report))["totals"];
    EXPECT_GT(totals["points_removed"].get<double>(),
              0.8 * totals["points_on_vertical_segments"].get<double>());
}

}  // namespace
