// SPDX-License-Identifier: BSD-3-Clause
#include "Exports.h"

#include "../support/Places.h"
#include "EndlessFile.h"
#include "OfficeLogs.h"
#include "WaitFor.h"

#include <gmock/gmock.h>

#include <mutex>

namespace offmap::window {

namespace {

using test::waitFor;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::chrono::seconds aMoment{1};
constexpr size_t turns = 8;

class ExportsTest : public testing::Test {
 protected:
    ExportsTest() : exports_(FileReader({}, test::offmapBinary()), events()) {
        test::writeLog(log_, drive_);
    }

    Exports::Events events() {
        const auto note = [this](std::vector<std::string>& list) {
            return [this, &list](const std::string& text) {
                const std::lock_guard lock(mutex_);
                list.push_back(text);
            };
        };
        return {note(done_), note(failures_)};
    }
    bool ends(size_t count = 1) {
        return waitFor([&] {
            const std::lock_guard lock(mutex_);
            return done_.size() + failures_.size() >= count;
        });
    }
    void write(const TurnRange& range, const std::filesystem::path& file) {
        writeOf(test::requestOf(log_, {}), range, file);
    }
    void writeOf(const SessionRequest& request, const TurnRange& range,
                 const std::filesystem::path& file) {
        exports_.writeTurns(request, map_, range, file);
    }
    test::TemporaryFolder folder_;
    const std::filesystem::path log_ = folder_ / "drive.rawlog", out_ = folder_ / "out.rawlog";
    const test::Observations drive_ = test::officeDrive(turns);
    const std::shared_ptr<const core::LineMap> map_ = test::officeLines();
    std::mutex mutex_;
    std::vector<std::string> done_, failures_;
    Exports exports_;  // last: its thread calls what stands above
};

}  // namespace

TEST_F(ExportsTest, writesTheTurnsThatWereAskedFor) {
    write({2, 4}, out_);
    ASSERT_TRUE(ends());
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_THAT(done_, ElementsAre(AllOf(HasSubstr("wrote"), HasSubstr("out.rawlog"))));
    const auto written = test::observationsOf(out_);
    const auto times = test::scanTimes(drive_);
    EXPECT_THAT(test::scanTimes(written), ElementsAre(times[2], times[3], times[4]));
    EXPECT_LT(test::pointsIn(written), test::pointsIn(drive_) / turns * 3) << "reduced";
}

TEST_F(ExportsTest, writesTheLastTurn) {
    write({turns - 1, turns - 1}, out_);
    ASSERT_TRUE(ends());
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_THAT(test::scanTimes(test::observationsOf(out_)),
                ElementsAre(test::scanTimes(drive_).back()));
}

TEST_F(ExportsTest, trackedPosesComeFromAllTurnsBefore) {
    SessionRequest request = test::requestOf(log_, {});
    request.live.from.track = "2,2.5,17";
    writeOf(request, {4, 5}, out_);
    ASSERT_TRUE(ends());
    ASSERT_THAT(failures_, IsEmpty());
    const auto times = test::scanTimes(drive_);
    EXPECT_THAT(test::scanTimes(test::observationsOf(out_)), ElementsAre(times[4], times[5]));
}

TEST_F(ExportsTest, turnsThatTheLogDoesNotHaveAreToldOf) {
    write({turns, turns + 5}, out_);
    ASSERT_TRUE(ends());
    EXPECT_THAT(failures_, ElementsAre(AllOf(HasSubstr("drive.rawlog"), HasSubstr("9"))));
    EXPECT_THAT(folder_.names(), ElementsAre("drive.rawlog"));
}

TEST_F(ExportsTest, theLogItselfIsNotWrittenOver) {
    const std::string before = test::readFile(log_);
    write({0, 3}, log_);
    ASSERT_TRUE(ends());
    EXPECT_THAT(failures_, ElementsAre(HasSubstr("drive.rawlog")));
    EXPECT_EQ(test::readFile(log_), before);
}

TEST_F(ExportsTest, whatCannotBeWrittenIsToldOf) {
    write({0, 3}, folder_ / "missing" / "out.rawlog");
    exports_.writeFigure(test::officeFrame(0), map_, {}, Theme::darkOne(), "/proc/figure.png");
    ASSERT_TRUE(ends(2));
    EXPECT_THAT(failures_, ElementsAre(HasSubstr("missing/out.rawlog"), HasSubstr("figure.png")));
}

TEST_F(ExportsTest, whatCannotBeReadIsToldOf) {
    writeOf(test::requestOf(folder_ / "none.rawlog", {}), {0, 3}, out_);
    ASSERT_TRUE(ends());
    EXPECT_THAT(failures_, ElementsAre(HasSubstr("none.rawlog")));
    EXPECT_THAT(folder_.names(), ElementsAre("drive.rawlog"));
}

TEST_F(ExportsTest, aFigureIsAPicture) {
    exports_.writeFigure(test::officeFrame(0), map_, {}, Theme::lightOne(), folder_ / "figure.png");
    ASSERT_TRUE(ends());
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_EQ(test::readFile(folder_ / "figure.png").substr(1, 3), "PNG");
}

TEST_F(ExportsTest, oneIsWrittenAfterTheOther) {
    write({0, 1}, out_);
    write({2, 3}, folder_ / "more.rawlog");
    ASSERT_TRUE(ends(2));
    EXPECT_THAT(done_, ElementsAre(HasSubstr("out.rawlog"), HasSubstr("more.rawlog")));
}

TEST_F(ExportsTest, closingWhileALogIsReadLeavesNoFile) {
    test::EndlessFile endless(folder_ / "endless.rawlog");
    writeOf(test::requestOf(endless.path(), {}), {0, 3}, out_);
    ASSERT_TRUE(endless.isRead());
    EXPECT_LT(test::timeOf([&] { exports_.close(); }), aMoment);
    EXPECT_THAT(folder_.names(), UnorderedElementsAre("drive.rawlog", "endless.rawlog"));
    EXPECT_THAT(failures_, IsEmpty());
}

TEST_F(ExportsTest, closingEndsThoseThatWaitToo) {
    test::EndlessFile endless(folder_ / "endless.rawlog");
    writeOf(test::requestOf(endless.path(), {}), {0, 3}, out_);
    ASSERT_TRUE(endless.isRead());
    write({0, 3}, folder_ / "more.rawlog");
    EXPECT_LT(test::timeOf([&] { exports_.close(); }), aMoment);
    EXPECT_THAT(folder_.names(), UnorderedElementsAre("drive.rawlog", "endless.rawlog"));
    EXPECT_THAT(done_, IsEmpty());
}

TEST_F(ExportsTest, endsWhileItWrites) {
    {
        test::EndlessFile endless(folder_ / "endless.rawlog");
        Exports ending(FileReader({}, test::offmapBinary()), events());
        ending.writeTurns(test::requestOf(endless.path(), {}), map_, {0, 3}, out_);
        ASSERT_TRUE(endless.isRead());
        ending.writeTurns(test::requestOf(log_, {}), map_, {0, 3}, out_);
    }
    EXPECT_THAT(folder_.names(), UnorderedElementsAre("drive.rawlog", "endless.rawlog"));
}

}  // namespace offmap::window
