// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPane.h"

#include "../MadeUpFrame.h"
#include "DrawnPicture.h"

#include <gtest/gtest.h>

#include <vector>

namespace offmap::window {

namespace {

using test::hasColour;
using test::spotOf;

/// The hall, 20 m by 12 m, on 500 px by 300 px: 88 % of 25 px/m.
class PlanPaneTest : public testing::Test {
 protected:
    PlanPaneTest() {
        plan_->onLookAt = [this](const mrpt::math::TPoint2D& place) { looks_.push_back(place); };
        plan_->setMap(test::hallMap());
    }

    static int xOf(double x) { return static_cast<int>(250 + (x - 10) * 22); }
    static int yOf(double y) { return static_cast<int>(150 - (y - 6) * 22); }

    mrpt::math::TPoint2D placeUnder(int x, int y) {
        plan_.mouse(wxEVT_LEFT_DCLICK, x, y);
        return looks_.back();
    }

    /// How blue, the colour of walls, one pixel to either side of a row or column is at most.
    static int wallAt(const wxImage& picture, int x, int y) {
        int most = 0;
        for (int i = 0; i < 9; ++i) {
            const int px = x - 1 + i % 3, py = y - 1 + i / 3;
            most = std::max(most, picture.GetBlue(px, py) - picture.GetRed(px, py));
        }
        return most;
    }

    test::PaneOnScreen<PlanPane> plan_{500, 300};
    std::vector<mrpt::math::TPoint2D> looks_;
};

constexpr int bluish = 60;  // half a wall's colour in either theme, and a smooth edge's share

live::LiveFramePtr shared(const live::LiveFrame& frame) {
    return std::make_shared<live::LiveFrame>(frame);
}

}  // namespace

TEST_F(PlanPaneTest, wallsStandWhereTheMapHasThem) {
    for (const Theme* theme : {&Theme::darkOne(), &Theme::lightOne()}) {
        plan_->setTheme(*theme);
        const wxImage picture = plan_.picture();
        EXPECT_GT(wallAt(picture, xOf(0), yOf(6)), bluish);
        EXPECT_GT(wallAt(picture, xOf(20), yOf(6)), bluish);
        EXPECT_GT(wallAt(picture, xOf(5), yOf(12)), bluish);
        EXPECT_GT(wallAt(picture, xOf(10), yOf(7)), bluish) << "the round column";
        EXPECT_LT(wallAt(picture, xOf(10), yOf(6)), bluish) << "its inside";
        EXPECT_LT(wallAt(picture, xOf(5), yOf(3)), bluish) << "nothing";
    }
}

TEST_F(PlanPaneTest, theRobotStandsWhereItWasSaidAndSeenToStand) {
    plan_->show(shared(test::madeUpFrame()));
    const wxImage picture = plan_.picture();
    const Theme& theme = Theme::darkOne();
    // Half of the stated arrow is hidden by the refined one, 6.6 px to its right.
    const auto stated =
        spotOf(picture, toWx(theme.palette.sensor), {xOf(6) - 9, yOf(4) - 11, 18, 22});
    const auto refined = spotOf(picture, toWx(theme.palette.refined));
    EXPECT_GT(stated.count, 10);
    EXPECT_NEAR(refined.middleX(), xOf(6.3), 2);
    // Its 80 px^2 less an outline of 53 px, half of which is inside, and smooth edges.
    EXPECT_GT(refined.count, 20);
    const wxRect ahead(xOf(6.3) - 10, yOf(4) - 11, 20, 9), behind(xOf(6.3) - 10, yOf(4) + 2, 20, 9);
    const auto point = spotOf(picture, toWx(theme.palette.refined), ahead);
    const auto wings = spotOf(picture, toWx(theme.palette.refined), behind);
    EXPECT_LT(point.right - point.left, wings.right - wings.left) << "along the map's y axis";
    EXPECT_GT(point.count, 0);
}

TEST_F(PlanPaneTest, theEllipseReachesThreeDeviations) {
    live::LiveFrame frame = test::madeUpFrame();
    frame.reduced.vehicleInMap.reset();
    plan_->show(shared(frame));
    const wxImage picture = plan_.picture();
    const wxColour ground = Theme::darkOne().background;
    // 0.6 m along x are 13.2 px, 0.3 m along y 6.6 px.
    EXPECT_FALSE(hasColour(picture, xOf(6) + 12, yOf(4), ground));
    EXPECT_TRUE(hasColour(picture, xOf(6) + 16, yOf(4), ground));
    EXPECT_FALSE(hasColour(picture, xOf(6) - 12, yOf(4), ground));
    EXPECT_TRUE(hasColour(picture, xOf(6) - 16, yOf(4), ground));
}

TEST_F(PlanPaneTest, keptReturnsAreDotsInTheMap) {
    plan_->show(shared(test::madeUpFrame()));
    const auto dots = spotOf(plan_.picture(), toWx(Theme::darkOne().palette.kept));
    EXPECT_EQ(dots.count, 4);             // eleven in the same place
    EXPECT_NEAR(dots.left, xOf(9.3), 1);  // as the scan was found to have been taken
    EXPECT_NEAR(dots.top, yOf(4), 1);
    plan_->show(nullptr);
    EXPECT_EQ(spotOf(plan_.picture(), toWx(Theme::darkOne().palette.kept)).count, 0);
}

TEST_F(PlanPaneTest, theTrajectoryStaysUntilItIsCleared) {
    live::LiveFrame frame = test::madeUpFrame();
    frame.reduced.vehicleInMap.reset();
    plan_->show(shared(frame));
    frame.reduced.record.time += std::chrono::seconds(1);
    frame.reduced.organized.scan.columns[0].sensor->sensorInMap = {6, 7, 1, 0, 0, 0};
    plan_->show(shared(frame));
    plan_->show(nullptr);
    const auto between = wxRect(xOf(6) - 2, yOf(6), 5, 20);
    const wxColour ground = Theme::darkOne().background;
    EXPECT_LE(spotOf(plan_.picture(), ground, between).count, 80);  // of 100: a line of 20 px
    plan_->clearTrajectory();
    EXPECT_EQ(spotOf(plan_.picture(), ground, between).count, 100);
}

TEST_F(PlanPaneTest, aDoubleClickLooksAtThePlaceUnderThePointer) {
    const auto place = placeUnder(xOf(4), yOf(9));
    EXPECT_NEAR(place.x, 4, 1.0 / 22);  // a pixel
    EXPECT_NEAR(place.y, 9, 1.0 / 22);
}

TEST_F(PlanPaneTest, theWheelZoomsAboutThePointer) {
    const auto before = placeUnder(100, 80);
    plan_.wheel(2, 100, 80);
    const auto after = placeUnder(100, 80);
    EXPECT_NEAR(after.x, before.x, 1e-9);
    EXPECT_NEAR(after.y, before.y, 1e-9);
    EXPECT_NEAR(placeUnder(200, 80).x - after.x, 100 / (22 * 1.44), 1e-9);
}

TEST_F(PlanPaneTest, aDragMovesTheMapAndFFitsItAgain) {
    const auto before = placeUnder(100, 80);
    plan_.mouse(wxEVT_LEFT_DOWN, 100, 80, true);
    plan_.mouse(wxEVT_MOTION, 150, 60, true);
    plan_.mouse(wxEVT_LEFT_UP, 150, 60);
    EXPECT_NEAR(placeUnder(150, 60).x, before.x, 1e-9);
    EXPECT_NEAR(placeUnder(150, 60).y, before.y, 1e-9);
    plan_.key('F');
    EXPECT_NEAR(placeUnder(100, 80).x, before.x, 1e-9);
}

TEST_F(PlanPaneTest, denseMapsAreDrawnToo) {
    std::vector<core::Wall> walls;
    for (int i = 0; i < 6000; ++i) walls.push_back({{{0.001 * i, 0}, {0.001 * i, 6}}});
    plan_->setMap(std::make_shared<core::LineMap>(walls));
    const auto drawn = spotOf(plan_.picture(), toWx(Theme::darkOne().palette.wall));
    // 6 m by 6 m on 264 px each way, as one filled square.
    EXPECT_NEAR(drawn.right - drawn.left, 264, 2);
    EXPECT_NEAR(drawn.bottom - drawn.top, 264, 2);
}

TEST_F(PlanPaneTest, withoutAMapOrWithAnEmptyOneIsDrawn) {
    plan_->show(shared(test::madeUpFrame()));
    plan_->setMap(nullptr);
    EXPECT_EQ(plan_.picture().GetWidth(), 500);
    plan_->setMap(std::make_shared<core::LineMap>(std::vector<core::Wall>{}));
    EXPECT_EQ(plan_.picture().GetWidth(), 500);
}

TEST_F(PlanPaneTest, posesAtTheEndOfTheWorldAreLeftOut) {
    live::LiveFrame frame = test::madeUpFrame();
    auto& pose = *frame.reduced.organized.scan.columns[0].sensor;
    pose.groundCovariance.diagonal() << 1e30, 1e30, 1;
    pose.sensorInMap = {1e30, 0, 0, 0, 0, 0};
    frame.reduced.vehicleInMap.reset();
    plan_->show(shared(frame));
    EXPECT_EQ(spotOf(plan_.picture(), toWx(Theme::darkOne().palette.sensor)).count, 0);
}

}  // namespace offmap::window
