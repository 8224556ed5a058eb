// SPDX-License-Identifier: BSD-3-Clause
#include "PlaybackFixture.h"

#include <csignal>
#include <sys/resource.h>

namespace offmap::window {

namespace {

using testing::ElementsAre;

class RecordingTest : public test::PlaybackFixture {};

/// While it lives, files of this program end there.
class SmallDisk {
 public:
    explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

 private:
    void (*handler_)(int);
    rlimit before_{};
};

}  // namespace

TEST_F(RecordingTest, aRecordingAppearsWhenFinishedAndHoldsWhatWasPlayed) {
    open(false);
    ASSERT_TRUE(comes(1));
    const auto file = *folder_ / "recorded.rawlog";
    playback_->record(file);
    EXPECT_TRUE(playback_->recording());
    for (const uint64_t turn : {1, 2, 3}) {
        playback_->step(1);
        ASSERT_TRUE(comesTo(turn));
    }
    ASSERT_TRUE(comes(4));
    EXPECT_FALSE(std::filesystem::exists(file));
    playback_->finishRecording();
    EXPECT_FALSE(playback_->recording());
    playback_->step(1);
    ASSERT_TRUE(comesTo(4));
    const auto recorded = test::observationsOf(file), all = drive_;
    const auto times = test::scanTimes(all);
    EXPECT_THAT(test::scanTimes(recorded), ElementsAre(times[1], times[2], times[3]));
    EXPECT_LT(test::pointsIn(recorded), test::pointsIn(all) / turns * 3) << "reduced";
    EXPECT_GT(test::pointsIn(recorded), 0U);
    std::filesystem::remove(file);
}

TEST_F(RecordingTest, aRecordingThatWasNotFinishedLeavesNoFile) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->record(*folder_ / "unfinished.rawlog");
    playback_->step(1);
    ASSERT_TRUE(comes(2));
    playback_.reset();
    EXPECT_THAT(folder_->names(), ElementsAre("drive.rawlog"));
}

TEST_F(RecordingTest, aRecordingWhereThereIsNoFolderIsRefusedWithItsName) {
    open(false);
    try {
        playback_->record(*folder_ / "missing" / "a.rawlog");
        FAIL() << "it records nowhere";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("missing/a.rawlog"));
    }
    EXPECT_FALSE(playback_->recording());
}

TEST_F(RecordingTest, aLogIsNotRecordedOverItself) {
    open(false);
    ASSERT_TRUE(comes(1));
    EXPECT_THROW(playback_->record(log()), std::runtime_error);
    EXPECT_FALSE(playback_->recording());
}

TEST_F(RecordingTest, aDiskThatIsFullEndsTheRecordingAndNotThePlaying) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->record(*folder_ / "full.rawlog");
    const SmallDisk disk(1000);  // [byte] a scan has some 30,000
    playback_->play();
    ASSERT_TRUE(comes(turns));
    ASSERT_TRUE(ends());
    EXPECT_EQ(playback_->failure(), "");
    try {
        playback_->finishRecording();
        FAIL() << "nobody hears of it";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("full.rawlog"));
    }
    EXPECT_FALSE(playback_->recording());
    EXPECT_NO_THROW(playback_->finishRecording()) << "once is enough";
    EXPECT_THAT(folder_->names(), ElementsAre("drive.rawlog"));
}

}  // namespace offmap::window
