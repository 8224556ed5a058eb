// SPDX-License-Identifier: BSD-3-Clause
#include "StageFixture.h"

namespace offmap::window {

namespace {

using test::pumpUntil;

class ScanStageTest : public test::StageFixture {};

}  // namespace

TEST_F(ScanStageTest, aPictureIsAsLargeAsTheCanvasAndOnTheThemesGround) {
    for (const Theme* theme : {&Theme::lightOne(), &Theme::darkOne()}) {
        stage_->setTheme(*theme);
        const wxImage picture = this->picture();
        ASSERT_TRUE(picture.IsOk());
        EXPECT_EQ(picture.GetSize(), stage_->canvas().GetClientSize());
        EXPECT_EQ(picture.GetSize(), stage_->GetClientSize()) << "it fills the stage";
        EXPECT_TRUE(test::hasColour(picture, 3, 3, toWx(theme->palette.background)));
    }
}

TEST_F(ScanStageTest, whatWasRemovedIsRedUntilItIsHidden) {
    stage_->setMap(test::officeLines());
    ASSERT_TRUE(shows(test::officeFrame(0)));
    choose([](SceneChoices&) {});
    const int before = redIn(picture());
    EXPECT_GT(before, 500) << "some 2,000 points of 2.5 px";
    choose([](SceneChoices& choices) { choices.shown.mapped = false; });
    EXPECT_EQ(redIn(picture()), 0);
    choose([](SceneChoices& choices) { choices.shown.mapped = true; });
    EXPECT_NEAR(redIn(picture()), before, before / 50);
    choose([](SceneChoices& choices) { choices.colourBy = view::ColourBy::Height; });
    EXPECT_LT(redIn(picture()), before / 10);
}

TEST_F(ScanStageTest, largerPointsCoverMore) {
    stage_->setMap(test::officeLines());
    ASSERT_TRUE(shows(test::officeFrame(0)));
    choose([](SceneChoices& choices) { choices.pointSize = 1; });
    const int small = redIn(picture());
    choose([](SceneChoices& choices) { choices.pointSize = 6; });
    EXPECT_GT(redIn(picture()), 2 * small);
}

TEST_F(ScanStageTest, wallsAreDrawnUntilTheyAreHidden) {
    stage_->setMap(test::officeLines());
    const auto blue = [&] {
        const wxImage picture = this->picture();
        int count = 0;
        for (int y = 0; y < picture.GetHeight(); ++y) {
            for (int x = 0; x < picture.GetWidth(); ++x) {
                count += picture.GetBlue(x, y) > picture.GetRed(x, y) + 30;
            }
        }
        return count;
    };
    EXPECT_GT(blue(), 1000) << "without a scan, too";
    SceneChoices choices;
    choices.shown.walls = false;
    stage_->setChoices(choices);
    EXPECT_EQ(blue(), 0);
}

TEST_F(ScanStageTest, anotherLookDoesNotBringAnOlderScanBack) {
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    const auto newer = test::sharedMadeUpFrame();
    stage_->take(newer);
    stage_->setTheme(Theme::lightOne());  // before the newer one is on the screen
    // Long enough for all that may still be composed to come; one takes some 2 ms.
    pumpUntil([] { return false; }, std::chrono::milliseconds(200));
    EXPECT_EQ(stage_->shown()->frame, newer);
}

TEST_F(ScanStageTest, aLookThatChangesBeforeTheFirstScanIsShownKeepsTheScan) {
    const auto first = test::sharedMadeUpFrame();
    stage_->take(first);
    stage_->setTheme(Theme::lightOne());
    EXPECT_TRUE(showsNow(first));
}

TEST_F(ScanStageTest, scansWithoutReturnsAreShown) {
    auto empty = std::make_shared<live::LiveFrame>(test::madeUpFrame());
    empty->reduced.organized.scan.points.clear();
    empty->reduced.organized.scan.columns[0].end = 0;
    empty->result.labels.clear();
    ASSERT_TRUE(shows(empty));
    EXPECT_TRUE(picture().IsOk());
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
}

TEST_F(ScanStageTest, whatIsClearedIsGone) {
    stage_->setMap(test::officeLines());
    ASSERT_TRUE(shows(test::officeFrame(0)));
    EXPECT_GT(redIn(picture()), 0);
    stage_->clear();
    EXPECT_FALSE(stage_->shown());
    EXPECT_EQ(redIn(picture()), 0);
}

TEST_F(ScanStageTest, thereIsNoPictureOfAWindowThatIsNotShown) {
    ASSERT_TRUE(picture().IsOk());
    frame_->Hide();
    wxYield();
    EXPECT_FALSE(picture().IsOk());
}

}  // namespace offmap::window
