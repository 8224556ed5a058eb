// SPDX-License-Identifier: BSD-3-Clause
#include "TimelinePane.h"

#include "DrawnPicture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace offmap::window {

namespace {

using test::spotOf;
using testing::ElementsAre;

/// A timeline of 100 turns whose strip is 400 px wide and 60 px high: 4 px a turn.
class TimelinePaneTest : public testing::Test {
 protected:
    TimelinePaneTest() {
        timeline_->setTurns(100);
        timeline_->onJump = [this](uint64_t number) { jumps_.push_back(number); };
    }

    /// [px] the middle of a turn
    static int xOf(int turn) { return left + 4 * turn + 2; }

    static constexpr int left = 136, top = 7, bottom = 67;  // of the strip [px]
    static constexpr int middle = (top + bottom) / 2;
    test::PaneOnScreen<TimelinePane> timeline_{left + 400 + 50, bottom + 24};
    std::vector<uint64_t> jumps_;
};

}  // namespace

TEST_F(TimelinePaneTest, thePlaceNowIsALineWhereTheTurnIs) {
    for (const Theme* theme : {&Theme::darkOne(), &Theme::lightOne()}) {
        timeline_->setTheme(*theme);
        for (const int turn : {0, 50, 99}) {
            timeline_->setPosition(static_cast<uint64_t>(turn));
            const auto line = spotOf(timeline_.picture(), theme->accent, {0, top + 5, 586, 40});
            EXPECT_NEAR(line.middleX(), xOf(turn), 1) << turn;
            EXPECT_LE(line.right - line.left, 2);
            EXPECT_EQ(line.bottom - line.top, 39);
        }
    }
}

TEST_F(TimelinePaneTest, theRemovedShareIsFilledUpToItsValue) {
    for (uint64_t i = 20; i < 40; ++i) timeline_->add(i, 0.5, 1, false);
    const wxImage picture = timeline_.picture();
    const auto redAt = [&](int x, int y) {
        return picture.GetRed(x, y) - picture.GetGreen(x, y) > 60;
    };
    EXPECT_TRUE(redAt(xOf(30), middle + 3));
    EXPECT_FALSE(redAt(xOf(30), middle - 3));
    EXPECT_TRUE(redAt(xOf(20), middle + 3));
    EXPECT_TRUE(redAt(xOf(39), middle + 3));
    EXPECT_FALSE(redAt(xOf(18), middle + 3)) << "a turn that nobody has seen";
    EXPECT_FALSE(redAt(xOf(41), middle + 3)) << "a turn that nobody has seen";
}

TEST_F(TimelinePaneTest, suspectTurnsAreMarkedBelowTheStrip) {
    for (uint64_t i = 0; i < 100; ++i) timeline_->add(i, 0.5, 1, i == 70);
    const auto mark = spotOf(timeline_.picture(), Theme::darkOne().bad, {left, bottom, 400, 6});
    EXPECT_NEAR(mark.middleX(), xOf(70), 1);
    EXPECT_GE(mark.count, 12);  // 4 px by 4 px, but for its smooth edges
}

TEST_F(TimelinePaneTest, theTimeIsALineOnItsOwnScale) {
    // Of 5 ms at most: 2.5 ms are half as high as the strip.
    for (uint64_t i = 0; i < 100; ++i) timeline_->add(i, 0, i == 99 ? 5 : 2.5, false);
    const wxImage picture = timeline_.picture();
    int bluest = 0, bluestY = 0;
    for (int y = top; y < bottom; ++y) {
        const int blue = picture.GetBlue(xOf(30), y) - picture.GetRed(xOf(30), y);
        if (blue > bluest) {
            bluest = blue;
            bluestY = y;
        }
    }
    EXPECT_NEAR(bluestY, middle, 1);
}

TEST_F(TimelinePaneTest, aClickJumpsToTheTurnUnderThePointer) {
    timeline_.mouse(wxEVT_LEFT_DOWN, xOf(42), middle, true);
    timeline_.mouse(wxEVT_LEFT_UP, xOf(42), middle);
    EXPECT_THAT(jumps_, ElementsAre(42U));
}

TEST_F(TimelinePaneTest, aDragJumpsOnAndEndsAtTheEdges) {
    timeline_.mouse(wxEVT_LEFT_DOWN, xOf(42), middle, true);
    timeline_.mouse(wxEVT_MOTION, xOf(43), middle, true);
    timeline_.mouse(wxEVT_MOTION, 5000, middle, true);
    timeline_.mouse(wxEVT_MOTION, -5000, middle, true);
    timeline_.mouse(wxEVT_LEFT_UP, -5000, middle);
    timeline_.mouse(wxEVT_MOTION, xOf(10), middle);
    EXPECT_THAT(jumps_, ElementsAre(42U, 43U, 99U, 0U));
}

TEST_F(TimelinePaneTest, keysStepThroughTheTurns) {
    timeline_->setPosition(50);
    for (const int key :
         {WXK_RIGHT, WXK_LEFT, WXK_PAGEDOWN, WXK_PAGEUP, WXK_END, WXK_RIGHT, WXK_HOME, WXK_LEFT}) {
        timeline_.key(key);
    }
    EXPECT_THAT(jumps_, ElementsAre(51U, 50U, 60U, 50U, 99U, 0U));
}

TEST_F(TimelinePaneTest, tooltipTellsTheTurnUnderThePointer) {
    timeline_->add(42, 0.923, 4.25, true);
    timeline_.mouse(wxEVT_MOTION, xOf(42), middle);
    EXPECT_EQ(timeline_->GetToolTipText(),
              "turn 43: 92.3 % removed, 4.25 ms, does not fit the map");
    timeline_.mouse(wxEVT_MOTION, xOf(43), middle);
    EXPECT_EQ(timeline_->GetToolTipText(), "turn 44");
    timeline_->add(43, 0.5, 4, false);
    timeline_.mouse(wxEVT_MOTION, xOf(43), middle);
    EXPECT_EQ(timeline_->GetToolTipText(), "turn 44: 50.0 % removed, 4.00 ms");
}

TEST_F(TimelinePaneTest, clearLeavesNoCurve) {
    for (uint64_t i = 0; i < 100; ++i) timeline_->add(i, 1, 1, false);
    timeline_->clear();
    const wxImage picture = timeline_.picture();
    EXPECT_LT(picture.GetRed(xOf(30), middle) - picture.GetGreen(xOf(30), middle), 30);
}

TEST_F(TimelinePaneTest, theSmallestPaneIsDrawnAndAnswersClicks) {
    test::PaneOnScreen<TimelinePane> tiny(1, 1);
    tiny->setTurns(1);
    tiny->add(0, 1, 0, true);
    EXPECT_EQ(tiny.picture().GetWidth(), 1);
    tiny.mouse(wxEVT_LEFT_DOWN, 0, 0, true);
    tiny.mouse(wxEVT_LEFT_UP, 0, 0);
}

}  // namespace offmap::window
