// SPDX-License-Identifier: BSD-3-Clause
#include "EndlessFile.h"
#include "SessionFixture.h"

namespace offmap::window {

namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::chrono::seconds aMoment{1};

class SessionEndTest : public test::SessionFixture {};

}  // namespace

TEST_F(SessionEndTest, whatIsOpenedNextWins) {
    test::EndlessFile log(folder_ / "endless.rawlog"), map(folder_ / "endless.txt");
    open(log.path(), {});
    ASSERT_TRUE(log.isRead());
    open(log_, map.path());
    open(fileOf("notes.rawlog", "Dear diary,\n"), map.path());
    open(log_, map_);
    EXPECT_TRUE(session_.opening());
    ASSERT_TRUE(answers());
    ASSERT_THAT(failures_, IsEmpty());
    EXPECT_THAT(opened_[0].sourceDescription, HasSubstr("drive.rawlog"));
    EXPECT_EQ(turnShown(), 0U);
    session_.close();
    EXPECT_EQ(opened_.size(), 1U);
}

TEST_F(SessionEndTest, openingReturnsAtOnce) {
    const test::EndlessFile endless(folder_ / "endless.rawlog");
    EXPECT_LT(test::timeOf([&] {
                  for (int i = 0; i < 10; ++i) open(endless.path(), map_);
              }),
              aMoment);
}

TEST_F(SessionEndTest, closesWhileItReadsALog) {
    test::EndlessFile endless(folder_ / "endless.rawlog");
    open(endless.path(), {});
    ASSERT_TRUE(endless.isRead());
    EXPECT_LT(test::timeOf([&] { session_.close(); }), aMoment);
    EXPECT_THAT(opened_, IsEmpty());
    EXPECT_THAT(failures_, IsEmpty()) << "it was not the file's fault";
    EXPECT_FALSE(session_.opening());
}

TEST_F(SessionEndTest, closesWhileItReadsAMap) {
    test::EndlessFile endless(folder_ / "endless.txt");
    open(log_, endless.path());
    ASSERT_TRUE(endless.isRead());
    EXPECT_LT(test::timeOf([&] { session_.close(); }), aMoment);
    EXPECT_THAT(opened_, IsEmpty());
    EXPECT_THAT(failures_, IsEmpty());
}

TEST_F(SessionEndTest, closesWhileItPlays) {
    SessionRequest request = test::requestOf(log_, {});
    request.play = true;
    session_.open(request);
    ASSERT_TRUE(answers());
    EXPECT_LT(test::timeOf([&] { session_.close(); }), aMoment);
    EXPECT_EQ(session_.playback(), nullptr);
    open(log_, {});
    ASSERT_TRUE(answers(2)) << "and can be used again";
    EXPECT_EQ(opened_.size(), 2U);
}

}  // namespace offmap::window
