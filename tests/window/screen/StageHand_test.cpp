// SPDX-License-Identifier: BSD-3-Clause
#include "StageFixture.h"

namespace offmap::window {

namespace {

using test::pumpUntil;

class StageHandTest : public test::StageFixture {};

}  // namespace

TEST_F(StageHandTest, aClickOnAReturnGivesItsStory) {
    stage_->setMap(test::hallMap());
    stage_->setCameraMode(CameraMode::Top);
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    click(pixelOf(9.3, 4));  // the pole, from where the scan was found to be taken
    ASSERT_TRUE(picked_);
    EXPECT_EQ(picked_->label, core::PointLabel::Kept);
    EXPECT_EQ(picked_->column, 0U);
    EXPECT_NEAR(picked_->range, std::hypot(3, 1), 1e-5) << "the uppermost of the pole's";
    ASSERT_TRUE(picked_->inMap);
    EXPECT_NEAR(picked_->inMap->x, 9.3, 1e-5);
    click(pixelOf(9.3, 6));
    EXPECT_FALSE(picked_) << "there is nothing";
}

TEST_F(StageHandTest, aClickOnAWallTellsOfTheWall) {
    const auto frame = test::officeFrame(0);
    stage_->setMap(test::officeLines());
    stage_->setCameraMode(CameraMode::Top);
    ASSERT_TRUE(shows(frame));
    const auto& returns = stage_->shown()->returns;
    const auto mapped = std::ranges::find(returns.labels, core::PointLabel::Mapped);
    ASSERT_NE(mapped, returns.labels.end());
    const auto& point = returns.points[static_cast<size_t>(mapped - returns.labels.begin())];
    click(pixelOf(point.x, point.y));
    ASSERT_TRUE(picked_ && picked_->inMap && picked_->segment);
    // Within 5 px, and half a pixel that the place was rounded by.
    const double reach = 6 * view::metresPerPixel(stage_->camera(), stage_->canvas().pictureSize());
    EXPECT_NEAR(picked_->inMap->x, point.x, reach);
    EXPECT_NEAR(picked_->inMap->y, point.y, reach);
    EXPECT_LT(picked_->wall.value_or(1000), test::officeLines()->walls().size());
}

TEST_F(StageHandTest, aSelectionEndsWithItsScan) {
    stage_->setMap(test::hallMap());
    stage_->setCameraMode(CameraMode::Top);
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    click(pixelOf(9.3, 4));
    ASSERT_TRUE(picked_);
    stage_->setTheme(Theme::lightOne());
    ASSERT_TRUE(pumpUntil([before = stage_->shown(), this] { return stage_->shown() != before; }));
    EXPECT_TRUE(picked_) << "the same scan in other colours";
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    EXPECT_TRUE(pumpUntil([&] { return !picked_; }));
}

TEST_F(StageHandTest, aClickWithoutAScanDoesNothing) {
    click({100, 100});
    stage_->resetView();
    stage_->clear();
    EXPECT_FALSE(picked_);
    EXPECT_TRUE(picture().IsOk());
}

TEST_F(StageHandTest, aButtonThatWasPressedElsewhereDoesNotClick) {
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    picks_ = 0;
    mouse(wxEVT_LEFT_UP, {100, 100});
    EXPECT_EQ(picks_, 0) << "it was for a dialog that has gone";
}

TEST_F(StageHandTest, aDragTurnsTheCameraAndIsNoClick) {
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    picks_ = 0;
    const view::Camera before = stage_->camera();
    drag({200, 200}, {260, 210}, wxMOUSE_BTN_LEFT);
    EXPECT_NE(stage_->camera().azimuth, before.azimuth);
    EXPECT_EQ(stage_->camera().target, before.target);
    const view::Camera turned = stage_->camera();
    drag({200, 200}, {260, 210}, wxMOUSE_BTN_RIGHT);
    EXPECT_EQ(stage_->camera().azimuth, turned.azimuth);
    EXPECT_NE(stage_->camera().target, turned.target);
    EXPECT_EQ(picks_, 0);
}

TEST_F(StageHandTest, fromAboveADragShiftsAndTheWheelKeepsWhatIsUnderThePointer) {
    stage_->setCameraMode(CameraMode::Top);
    ASSERT_TRUE(shows(test::sharedMadeUpFrame()));
    const wxPoint before = pixelOf(9.3, 4);
    drag(before, before + wxPoint(50, -30), wxMOUSE_BTN_LEFT);
    EXPECT_EQ(pixelOf(9.3, 4), before + wxPoint(50, -30));
    wxMouseEvent wheel(wxEVT_MOUSEWHEEL);
    wheel.SetPosition(pixelOf(9.3, 4));
    wheel.m_wheelDelta = 120;
    wheel.m_wheelRotation = 240;
    const double width = stage_->camera().shorterSide;
    stage_->canvas().GetEventHandler()->ProcessEvent(wheel);
    EXPECT_LT(stage_->camera().shorterSide, width);
    // The pole was rounded to half a pixel before.
    EXPECT_NEAR(pixelOf(9.3, 4).x, wheel.GetX(), 1);
    EXPECT_NEAR(pixelOf(9.3, 4).y, wheel.GetY(), 1);
}

TEST_F(StageHandTest, theCameraFollowsTheRobot) {
    stage_->setMap(test::officeLines());
    ASSERT_TRUE(shows(test::officeFrame(0, 2, 2.5)));
    stage_->setCameraMode(CameraMode::Follow);
    drag({200, 200}, {260, 210}, wxMOUSE_BTN_LEFT);
    const view::Camera before = stage_->camera();
    ASSERT_TRUE(shows(test::officeFrame(1, 3, 2)));
    const view::Camera after = stage_->camera();
    // Both poses are known to 2 cm, of which the scans leave less.
    EXPECT_NEAR(after.target.x - before.target.x, 1, 0.06);
    EXPECT_NEAR(after.target.y - before.target.y, -0.5, 0.06);
    EXPECT_EQ(after.azimuth, before.azimuth) << "as the hand has turned it";
    stage_->setCameraMode(CameraMode::Perspective);
    ASSERT_TRUE(shows(test::officeFrame(2, 2, 2.5)));
    EXPECT_EQ(stage_->camera().target, after.target);
}

}  // namespace offmap::window
