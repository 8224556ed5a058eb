// SPDX-License-Identifier: BSD-3-Clause
#include "SessionFixture.h"

namespace offmap::window {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionTest : public test::SessionFixture {};

/// A picture of a room of 6 m by 4 m, and what describes it.
void writeGrid(const std::filesystem::path& yaml, int wall) {
    std::string picture = "P5 60 40 255\n";
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 60; ++column) {
            const bool rim = row < wall || row >= 40 - wall || column < wall || column >= 60 - wall;
            picture += rim ? '\0' : '\xfe';
        }
    }
    test::writeFile(std::filesystem::path(yaml).replace_extension(".pgm"), picture);
    test::writeFile(yaml, "image: " + yaml.stem().string() +
                              ".pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
                              "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace

TEST_F(SessionTest, opensALogAndAMap) {
    open(log_, map_);
    EXPECT_TRUE(session_.opening() || session_.playback());
    ASSERT_TRUE(answers());
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_FALSE(session_.opening());
    EXPECT_EQ(opened_[0].turns, turns);
    EXPECT_EQ(opened_[0].map->walls().size(), mapOf(evaluation::officeRoom()).size());
    EXPECT_THAT(opened_[0].mapDescription, HasSubstr("office.txt"));
    EXPECT_THAT(opened_[0].sourceDescription, HasSubstr("drive.rawlog"));
    EXPECT_THAT(opened_[0].posesDescription, HasSubstr("LOCALIZATION"));
    EXPECT_THAT(opened_[0].warnings, IsEmpty());
    EXPECT_EQ(turnShown(), 0U);
    EXPECT_GT(session_.playback()->latest()->reduced.record.removed(), 0U);
}

TEST_F(SessionTest, opensAMapWithoutALog) {
    open({}, map_);
    ASSERT_TRUE(answers());
    ASSERT_EQ(opened_.size(), 1U);
    EXPECT_FALSE(opened_[0].map->walls().empty());
    EXPECT_EQ(session_.playback(), nullptr);
}

TEST_F(SessionTest, aLogWithoutAMapIsShownAndWarnedOf) {
    open(log_, {});
    ASSERT_TRUE(answers());
    ASSERT_EQ(opened_.size(), 1U);
    EXPECT_THAT(opened_[0].warnings, ElementsAre(HasSubstr("no map")));
    EXPECT_EQ(turnShown(), 0U);
}

TEST_F(SessionTest, tellsWhyALogCannotBeShown) {
    EXPECT_THAT(complaintAbout(folder_ / "none.rawlog", {}),
                AllOf(HasSubstr("none.rawlog"), HasSubstr("No such file")));
    EXPECT_THAT(complaintAbout(fileOf("notes.rawlog", "Dear diary,\n"), {}),
                HasSubstr("notes.rawlog"));
    EXPECT_THAT(complaintAbout(fileOf("empty.rawlog", ""), {}), HasSubstr("empty.rawlog"));
    EXPECT_THAT(complaintAbout(folder_.path(), {}), HasSubstr(folder_.path().string()));
    const auto begin = test::readFile(log_).substr(0, 40);
    EXPECT_THAT(complaintAbout(fileOf("begin.rawlog", begin), {}), HasSubstr("begin.rawlog"));
    test::SimulatedRobot robot;
    test::writeLog(folder_ / "odometry.rawlog", test::Observations{robot.odometry()});
    EXPECT_THAT(complaintAbout(folder_ / "odometry.rawlog", {}),
                AllOf(HasSubstr("odometry.rawlog"), HasSubstr("no 3D scans"),
                      HasSubstr("CObservationOdometry")));
    EXPECT_FALSE(isOfMap_);
}

TEST_F(SessionTest, tellsWhyAMapCannotBeRead) {
    EXPECT_THAT(complaintAbout(log_, folder_ / "none.txt"), HasSubstr("none.txt"));
    EXPECT_THAT(complaintAbout(log_, fileOf("bad.txt", "1 2 3\n")), HasSubstr("bad.txt"));
    EXPECT_THAT(complaintAbout(log_, log_), HasSubstr("drive.rawlog"));
    EXPECT_TRUE(isOfMap_);
}

TEST_F(SessionTest, aLogThatEndsTooEarlyIsShownAsFarAsItGoes) {
    const std::string whole = test::readFile(log_);
    const auto cut = fileOf("cut.rawlog", whole.substr(0, whole.size() * 2 / 3));
    open(cut, map_);
    ASSERT_TRUE(answers());
    ASSERT_EQ(opened_.size(), 1U) << failures_[0];
    EXPECT_GT(opened_[0].turns, 0U);
    EXPECT_LT(opened_[0].turns, turns);
    EXPECT_THAT(opened_[0].warnings, ElementsAre(HasSubstr("cut.rawlog")));
    EXPECT_EQ(turnShown(), 0U);
}

TEST_F(SessionTest, anotherMapShowsTheSameTurn) {
    open(log_, {}, 0);
    ASSERT_TRUE(answers());
    open(log_, map_, 5);
    ASSERT_TRUE(answers(2));
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_EQ(turnShown(), 5U);
    EXPECT_GT(session_.playback()->latest()->reduced.record.removed(), 0U);
}

TEST_F(SessionTest, aMapThatWasChangedIsReadAgain) {
    const auto wall = fileOf("one.txt", "0 0 5 0 0.02\n");
    open({}, wall);
    ASSERT_TRUE(answers());
    test::writeFile(wall, "0 0 5 0 0.02\n0 0 0 5 0.02\n");
    open({}, wall);
    ASSERT_TRUE(answers(2));
    EXPECT_EQ(opened_.back().map->walls().size(), 2U);
}

TEST_F(SessionTest, aPictureThatAMapNamesIsReadAgain) {
    const auto grid = folder_ / "grid.yaml";
    writeGrid(grid, 1);
    open({}, grid);
    ASSERT_TRUE(answers());
    ASSERT_EQ(opened_.size(), 1U) << failures_[0];
    const auto description = std::filesystem::last_write_time(grid);
    writeGrid(grid, 8);
    std::filesystem::last_write_time(grid, description);
    open({}, grid);
    ASSERT_TRUE(answers(2));
    ASSERT_EQ(opened_.size(), 2U) << failures_[0];
    EXPECT_NE(opened_[0].mapDescription, opened_[1].mapDescription) << "lengths of walls";
}

TEST_F(SessionTest, warningsOfAMapComeWithEveryLog) {
    const auto grid = folder_ / "grid.yaml";
    writeGrid(grid, 1);
    test::writeFile(grid, test::readFile(grid) + "colour: red\n");
    open({}, grid);
    ASSERT_TRUE(answers());
    open({}, grid);
    ASSERT_TRUE(answers(2));
    ASSERT_EQ(opened_.size(), 2U) << failures_[0];
    EXPECT_THAT(opened_[0].warnings, ElementsAre(HasSubstr("colour")));
    EXPECT_THAT(opened_[1].warnings, ElementsAre(HasSubstr("colour")));
}

TEST_F(SessionTest, parametersOfTheMapAreObeyed) {
    SessionRequest request = test::requestOf({}, fileOf("one.txt", "0 0 5 0\n"));
    request.config.map.sigma = 0.07;
    session_.open(request);
    ASSERT_TRUE(answers());
    ASSERT_EQ(opened_.size(), 1U) << failures_[0];
    EXPECT_EQ(opened_[0].map->walls().at(0).sigma, 0.07);
}

}  // namespace offmap::window
