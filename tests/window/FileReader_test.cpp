// SPDX-License-Identifier: BSD-3-Clause
#include "FileReader.h"

#include "../maps/DrawingFixture.h"
#include "../support/Places.h"
#include "EndlessFile.h"
#include "OfficeLogs.h"
#include "WaitFor.h"

#include <gmock/gmock.h>

#include <thread>

namespace offmap::window {

namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::chrono::seconds aMoment{1};

class FileReaderTest : public testing::Test {
 protected:
    using Words = std::vector<std::string>;

    static maps::MapOfFile read(const std::filesystem::path& map, const Words& arguments = {}) {
        return FileReader(arguments, test::offmapBinary()).readMap(map, {}, {});
    }
    static std::string complaintAbout(const std::filesystem::path& map, const Words& arguments = {},
                                      const std::string& program = test::offmapBinary()) {
        try {
            FileReader(arguments, program).readMap(map, {}, {});
        } catch (const std::exception& error) {
            return error.what();
        }
        return "none";
    }
    std::filesystem::path fileOf(const std::string& name, const std::string& content) const {
        test::writeFile(folder_ / name, content);
        return folder_ / name;
    }

    test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(FileReaderTest, wallsComeAsTheyStandInTheFile) {
    const auto map = read(fileOf("two.txt", "0 0 5 0.25 0.02\n1 1 3 1 0.05\n"));
    ASSERT_EQ(map.walls.size(), 2U);
    EXPECT_EQ(map.walls[0].line.point2, mrpt::math::TPoint2D(5, 0.25));
    EXPECT_EQ(map.walls[1].sigma, 0.05);
}

TEST_F(FileReaderTest, whatIsWrongWithAMapIsTold) {
    EXPECT_THAT(complaintAbout(fileOf("bad.txt", "0 0 5 0\n1 2 three 4\n")),
                AllOf(HasSubstr("bad.txt"), HasSubstr("2"), HasSubstr("three")));
    EXPECT_THAT(complaintAbout(folder_ / "none.dxf"), HasSubstr("none.dxf"));
    EXPECT_THAT(complaintAbout(folder_.path()), HasSubstr(folder_.path().string()));
}

TEST_F(FileReaderTest, optionsOfTheCommandLineReachTheReader) {
    const auto plan = fileOf("plan.dxf", test::dxf("0 LINE 8 WALLS 10 0 20 0 11 8 21 0"
                                                   " 0 LINE 8 DOORS 10 0 20 3 11 4 21 3",
                                                   "", "9 $ACADVER 1 AC1015 9 $INSUNITS 70 6"));
    EXPECT_EQ(read(plan).walls.size(), 2U);
    const auto map = read(plan, {"some.rawlog", "--map", plan.string(), "--map-layer", "WALLS",
                                 "--map-scale", "0.5", "--play"});
    ASSERT_EQ(map.walls.size(), 1U);
    EXPECT_NEAR(map.walls[0].line.length(), 4, 1e-9);
    EXPECT_THAT(complaintAbout(plan, {"--map-scale", "-1"}), HasSubstr("--map-scale"));
}

TEST_F(FileReaderTest, parametersReachTheReader) {
    rawlog::Config config;
    config.map.sigma = 0.0625;
    const FileReader reader({}, test::offmapBinary());
    const auto map = reader.readMap(fileOf("one.txt", "0 0 5 0\n"), config, {});
    EXPECT_EQ(map.walls.at(0).sigma, 0.0625);
}

TEST_F(FileReaderTest, aReaderThatDiesIsToldOf) {
    EXPECT_THAT(complaintAbout("plan.dxf", {}, "/bin/false"),
                AllOf(HasSubstr("plan.dxf"), HasSubstr("code 1")));
    EXPECT_THAT(complaintAbout("plan.dxf", {}, folder_ / "no program"),
                HasSubstr("cannot start the reading process"));
}

TEST_F(FileReaderTest, halfOfAMapIsNone) {
    const auto script = fileOf("half.sh", "#!/bin/sh\nprintf half\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    EXPECT_NE(complaintAbout("plan.dxf", {}, script), "none");
}

TEST_F(FileReaderTest, logsAreCheckedBeforeTheyAreOpened) {
    const FileReader reader({}, test::offmapBinary());
    test::writeLog(folder_ / "good.rawlog", test::officeDrive(1));
    EXPECT_NO_THROW(reader.checkLog(folder_ / "good.rawlog", {}, {}));
    try {
        reader.checkLog(fileOf("bad.rawlog", "no log"), {}, {});
        FAIL() << "a text is no log";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("bad.rawlog"));
    }
}

TEST_F(FileReaderTest, stoppedReadingEndsAtOnce) {
    test::EndlessFile endless(folder_ / "endless.txt");
    const FileReader reader({}, test::offmapBinary());
    std::stop_source stop;
    std::chrono::steady_clock::time_point stopped;
    const std::jthread stopper([&] {
        EXPECT_TRUE(endless.isRead());
        stopped = std::chrono::steady_clock::now();
        stop.request_stop();
    });
    EXPECT_THROW(reader.readMap(endless.path(), {}, stop.get_token()), Stopped);
    EXPECT_LT(std::chrono::steady_clock::now() - stopped, aMoment);
    EXPECT_THROW(reader.checkLog(endless.path(), {}, stop.get_token()), Stopped)
        << "it was stopped before";
}

}  // namespace offmap::window
