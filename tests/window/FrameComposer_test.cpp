// SPDX-License-Identifier: BSD-3-Clause
#include "FrameComposer.h"

#include "MadeUpFrame.h"
#include "WaitFor.h"

#include <gtest/gtest.h>

#include <atomic>

namespace offmap::window {

namespace {

using test::waitFor;

class FrameComposerTest : public testing::Test {
 protected:
    static live::LiveFramePtr frameOf(uint64_t number) {
        auto frame = std::make_shared<live::LiveFrame>(test::madeUpFrame());
        frame->arrived.number = number;
        return frame;
    }
    void compose(uint64_t number) { composer_.compose(frameOf(number), {}, {}); }
    bool composes(int times) {
        return waitFor([&] { return told_ >= times; });
    }
    /// The number of what was composed.
    std::optional<uint64_t> takenNumber() {
        const ComposedPtr composed = composer_.take();
        return composed ? std::optional(composed->frame->arrived.number) : std::nullopt;
    }

    std::atomic<int> told_ = 0;
    FrameComposer composer_{[this] { ++told_; }};  // last: its thread calls what stands above
};

}  // namespace

TEST_F(FrameComposerTest, placesReturnsWhereTheScanWasFoundToStand) {
    compose(3);
    ASSERT_TRUE(composes(1));
    const ComposedPtr composed = composer_.take();
    ASSERT_TRUE(composed);
    // The pole at (9, 4), seen from 0.3 m further along x than was stated.
    EXPECT_NEAR(composed->returns.points.at(0).x, 9.3, 1e-5);
    EXPECT_NEAR(composed->returns.points.at(0).y, 4, 1e-5);
    EXPECT_EQ(composed->returns.points.size(), 11U);
    EXPECT_FALSE(composed->cloud->empty());
    EXPECT_FALSE(composed->poses->empty());
    EXPECT_FALSE(composer_.take()) << "it was taken";
}

TEST_F(FrameComposerTest, composesOnlyWhatIsTaken) {
    compose(0);
    ASSERT_TRUE(composes(1));
    for (uint64_t number = 1; number <= 50; ++number) compose(number);
    EXPECT_EQ(takenNumber(), 0U);
    ASSERT_TRUE(composes(2));
    EXPECT_EQ(takenNumber(), 50U) << "the newest";
    compose(51);
    ASSERT_TRUE(composes(3));
    EXPECT_EQ(takenNumber(), 51U);
    EXPECT_EQ(told_, 3);
}

TEST_F(FrameComposerTest, forgetsWhatIsCleared) {
    compose(0);
    ASSERT_TRUE(composes(1));
    compose(1);
    composer_.clear();
    EXPECT_FALSE(takenNumber());
    compose(2);
    ASSERT_TRUE(composes(2));
    EXPECT_EQ(takenNumber(), 2U) << "what comes later is new";
    EXPECT_EQ(told_, 2);
}

TEST_F(FrameComposerTest, showsPosesOnlyIfAsked) {
    SceneChoices choices;
    choices.shown.ellipse = false;
    composer_.compose(frameOf(0), choices, {});
    ASSERT_TRUE(composes(1));
    EXPECT_FALSE(composer_.take()->poses);
}

TEST_F(FrameComposerTest, endsWithWorkWaiting) {
    for (uint64_t number = 0; number < 50; ++number) {
        FrameComposer composer([] {});
        composer.compose(frameOf(number), {}, {});
        composer.compose(frameOf(number + 1), {}, {});
    }
}

}  // namespace offmap::window
