// SPDX-License-Identifier: BSD-3-Clause
#include "Playback.h"

#include "OfficeLogs.h"
#include "WaitFor.h"

#include <gmock/gmock.h>

#include <atomic>
#include <csignal>
#include <mutex>
#include <sys/resource.h>

namespace offmap::window {

namespace {

using test::waitFor;
using testing::ElementsAre;
using testing::IsEmpty;
using Numbers = std::vector<uint64_t>;

constexpr uint64_t turns = 12;

class PlaybackTest : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<test::TemporaryFolder>();
        drive_ = test::officeDrive(turns);
        test::writeLog(log(), drive_);
    }
    static void TearDownTestSuite() { folder_.reset(); }
    static std::filesystem::path log() { return *folder_ / "drive.rawlog"; }

    void open(bool play, uint64_t startAt = 0) {
        app::LiveRequest request = test::requestOf(log(), {}).live;
        request.checkLog = [](const auto&, const auto&) {};
        app::LiveInput input = app::openLiveInput(request, config_);
        live::LiveSetup setup{std::make_shared<core::LineMap>(mapOf(evaluation::officeRoom())),
                              input.poses, config_};
        PlaybackEvents events;
        events.onFrame = [this](const live::LiveFramePtr& frame) { see(*frame); };
        events.onLatest = [this](const live::LiveFramePtr&) { ++latest_; };
        playback_ = std::make_unique<Playback>(std::move(input), std::move(setup),
                                               std::move(events), play, startAt);
    }

    void see(const live::LiveFrame& frame) {
        while (held_ && frame.arrived.number >= heldFrom_) std::this_thread::yield();
        const std::lock_guard lock(mutex_);
        seen_.push_back(frame.arrived.number);
    }
    Numbers seen() const {
        const std::lock_guard lock(mutex_);
        return seen_;
    }
    bool comes(size_t count) const {
        return waitFor([&] { return seen().size() >= count; });
    }
    /// Waits until a turn was reduced, and those before it.
    bool comesTo(uint64_t number) const {
        return waitFor([&] {
            const auto frame = playback_->latest();
            return frame && frame->arrived.number == number;
        });
    }
    bool ends() const {
        return waitFor([&] {
            return playback_->figures().source.state == live::SourceState::Ended &&
                   playback_->figures().turnsWaiting == 0;
        });
    }
    /// The numbers from one to before the other.
    static Numbers fromTo(uint64_t first, uint64_t end) {
        Numbers numbers;
        for (uint64_t n = first; n < end; ++n) numbers.push_back(n);
        return numbers;
    }

    static std::unique_ptr<test::TemporaryFolder> folder_;
    static test::Observations drive_;
    rawlog::Config config_;
    std::atomic<bool> held_ = false;  ///< the reduction, at this turn
    std::atomic<uint64_t> heldFrom_ = 0;
    std::atomic<int> latest_ = 0;  ///< how often a result was told of
    mutable std::mutex mutex_;
    Numbers seen_;
    std::unique_ptr<Playback> playback_;  // last: its threads call what stands above
};

std::unique_ptr<test::TemporaryFolder> PlaybackTest::folder_;
test::Observations PlaybackTest::drive_;

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

TEST_F(PlaybackTest, waitsAtTheFirstTurn) {
    open(false);
    ASSERT_TRUE(comes(1));
    EXPECT_FALSE(playback_->playing());
    EXPECT_TRUE(playback_->canPause());
    playback_->step(1);
    ASSERT_TRUE(comesTo(1));
    EXPECT_THAT(seen(), ElementsAre(0, 1)) << "nothing by itself";
}

TEST_F(PlaybackTest, waitsWhereItIsToldToBegin) {
    open(false, 7);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(comesTo(8));
    EXPECT_THAT(seen(), ElementsAre(7, 8));
}

TEST_F(PlaybackTest, playsToTheEndAndThenAnew) {
    open(true);
    ASSERT_TRUE(comes(turns));
    ASSERT_TRUE(ends());
    EXPECT_FALSE(playback_->playing());
    EXPECT_EQ(seen(), fromTo(0, turns)) << "as fast as it can, none is left out";
    playback_->play();
    ASSERT_TRUE(comes(2 * turns));
    ASSERT_TRUE(ends());
    Numbers twice = fromTo(0, turns);
    twice.insert(twice.end(), seen_.begin(), seen_.begin() + turns);
    EXPECT_EQ(seen(), twice);
}

TEST_F(PlaybackTest, playsAnewFromAnEndThatWasSteppedTo) {
    open(false, turns - 1);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(ends());
    playback_->play();
    ASSERT_TRUE(comes(1 + turns));
    ASSERT_TRUE(ends());
    EXPECT_EQ(seen().at(1), 0U);
    EXPECT_EQ(seen().back(), turns - 1);
}

TEST_F(PlaybackTest, pauseStopsAndStepsGoOnFromThere) {
    held_ = true;
    heldFrom_ = 2;
    open(true);
    ASSERT_TRUE(comes(2));
    EXPECT_TRUE(playback_->playing());
    playback_->pause();
    EXPECT_FALSE(playback_->playing());
    held_ = false;
    // One is being reduced, two wait, and one was just about to be handed on.
    ASSERT_TRUE(waitFor([&] { return playback_->figures().turnsWaiting == 0; }));
    const auto stopped = seen().size();
    EXPECT_LE(stopped, 6U);
    playback_->step(1);
    ASSERT_TRUE(comes(stopped + 1));
    EXPECT_EQ(seen(), fromTo(0, seen().size())) << "none twice, none left out";
    EXPECT_LT(seen().size(), turns);
    const uint64_t now = seen().back();
    playback_->step(-1);
    ASSERT_TRUE(comesTo(now - 1));
}

TEST_F(PlaybackTest, stepBackAtTheFirstTurnStaysThere) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->step(-1);
    ASSERT_TRUE(comes(2));
    EXPECT_THAT(seen(), ElementsAre(0, 0));
}

TEST_F(PlaybackTest, stepAtTheEndDoesNothing) {
    open(false, turns - 1);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(ends());
    playback_->step(1);
    playback_->step(-1);
    ASSERT_TRUE(comesTo(turns - 2));
    EXPECT_THAT(seen(), ElementsAre(turns - 1, turns - 2));
}

TEST_F(PlaybackTest, jumpsToATurnAndNoFurtherWhileItIsPaused) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->jumpTo(9);
    ASSERT_TRUE(comes(2));
    playback_->jumpTo(3);
    ASSERT_TRUE(comes(3));
    playback_->step(1);
    ASSERT_TRUE(comes(4));
    EXPECT_THAT(seen(), ElementsAre(0, 9, 3, 4));
}

TEST_F(PlaybackTest, aJumpBehindTheEndShowsNothingAndOneBackWorks) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->jumpTo(1000);
    ASSERT_TRUE(ends());
    playback_->jumpTo(2);
    ASSERT_TRUE(comes(2));
    EXPECT_THAT(seen(), ElementsAre(0, 2));
}

TEST_F(PlaybackTest, newParametersReduceTheSameTurnAgain) {
    open(false, 4);
    ASSERT_TRUE(comes(1));
    ASSERT_GT(playback_->latest()->reduced.record.removed(), 0U);
    rawlog::Config config;
    config.reduction.vertical.minLength = 30;  // [m] higher than the room
    playback_->setConfig(config);
    ASSERT_TRUE(waitFor([&] { return latest_ == 2; }));
    EXPECT_EQ(playback_->latest()->reduced.record.removed(), 0U);
    EXPECT_EQ(playback_->latest()->arrived.number, 4U);
    EXPECT_THAT(seen(), ElementsAre(4)) << "it is the same turn, not one more";
    playback_->step(1);
    ASSERT_TRUE(comesTo(5));
    EXPECT_EQ(playback_->latest()->reduced.record.removed(), 0U);
}

TEST_F(PlaybackTest, parametersThatCannotBeAreRefusedAndTheOthersStay) {
    open(false);
    ASSERT_TRUE(comes(1));
    rawlog::Config config;
    config.reduction.vertical.minLength = -1;
    EXPECT_THROW(playback_->setConfig(config), std::invalid_argument);
    playback_->step(1);
    ASSERT_TRUE(comesTo(1));
    EXPECT_GT(playback_->latest()->reduced.record.removed(), 0U);
}

TEST_F(PlaybackTest, aRecordingAppearsWhenFinishedAndHoldsWhatWasPlayed) {
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

TEST_F(PlaybackTest, aRecordingThatWasNotFinishedLeavesNoFile) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->record(*folder_ / "unfinished.rawlog");
    playback_->step(1);
    ASSERT_TRUE(comes(2));
    playback_.reset();
    EXPECT_THAT(folder_->names(), ElementsAre("drive.rawlog"));
}

TEST_F(PlaybackTest, aRecordingWhereThereIsNoFolderIsRefusedWithItsName) {
    open(false);
    try {
        playback_->record(*folder_ / "missing" / "a.rawlog");
        FAIL() << "it records nowhere";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("missing/a.rawlog"));
    }
    EXPECT_FALSE(playback_->recording());
}

TEST_F(PlaybackTest, aLogIsNotRecordedOverItself) {
    open(false);
    ASSERT_TRUE(comes(1));
    EXPECT_THROW(playback_->record(log()), std::runtime_error);
    EXPECT_FALSE(playback_->recording());
}

TEST_F(PlaybackTest, aDiskThatIsFullEndsTheRecordingAndNotThePlaying) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->record(*folder_ / "full.rawlog");
    {
        const SmallDisk disk(1000);  // [byte] a scan has some 30,000
        playback_->play();
        ASSERT_TRUE(comes(turns));
        ASSERT_TRUE(ends());
    }
    EXPECT_EQ(playback_->failure(), "");
    EXPECT_FALSE(playback_->recording());
    try {
        playback_->finishRecording();
        FAIL() << "nobody hears of it";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("full.rawlog"));
    }
    EXPECT_NO_THROW(playback_->finishRecording()) << "once is enough";
    EXPECT_THAT(folder_->names(), ElementsAre("drive.rawlog"));
}

TEST_F(PlaybackTest, endsWhileItPlays) {
    held_ = true;
    heldFrom_ = 3;
    open(true);
    ASSERT_TRUE(comes(3));
    held_ = false;
    playback_.reset();
    const Numbers before = seen();
    EXPECT_LT(before.size(), turns + 1);
    EXPECT_EQ(before, fromTo(0, before.size()));
}

}  // namespace offmap::window
