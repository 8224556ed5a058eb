// SPDX-License-Identifier: BSD-3-Clause
#include "PlanView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::window {

namespace {

constexpr double rounding = 1e-9;  // a few additions and products of numbers below 1e4

PlanView viewOf(double width, double height) {
    PlanView view;
    view.setSize(width, height);
    return view;
}

void expectNear(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
    EXPECT_NEAR(a.x, b.x, rounding);
    EXPECT_NEAR(a.y, b.y, rounding);
}

}  // namespace

TEST(PlanView, fitShowsTheWholeRectangleInTheMiddleUpwards) {
    PlanView view = viewOf(200, 100);
    view.fit({{10, 20}, {14, 30}});  // 10 m high on 100 px but 6 % above and below
    EXPECT_NEAR(view.scale(), 8.8, rounding);
    EXPECT_NEAR(view.toPixel({12, 25}).x, 100, rounding);
    EXPECT_NEAR(view.toPixel({12, 30}).y, 6, rounding);
    EXPECT_NEAR(view.toPixel({12, 20}).y, 94, rounding);
}

TEST(PlanView, pixelAndPlaceAreInverse) {
    PlanView view = viewOf(321, 123);
    view.fit({{-3, 500}, {90, 540}});
    const mrpt::math::TPoint2D place{17.25, 511.5};
    expectNear(view.toMap(view.toPixel(place)), place);
}

TEST(PlanView, zoomKeepsThePlaceUnderThePointer) {
    PlanView view = viewOf(300, 200);
    view.fit({{0, 0}, {20, 20}});
    const Pixel pointer{40, 170};
    const auto place = view.toMap(pointer);
    const double scale = view.scale();
    view.zoom(3, pointer);
    EXPECT_NEAR(view.scale(), 3 * scale, rounding);
    expectNear(view.toMap(pointer), place);
}

TEST(PlanView, zoomEndsAtItsLimits) {
    PlanView view = viewOf(300, 200);
    for (int i = 0; i < 500; ++i) view.zoom(2, {10, 10});
    EXPECT_EQ(view.scale(), 2e4);
    for (int i = 0; i < 500; ++i) view.zoom(0.5, {10, 10});
    EXPECT_EQ(view.scale(), 1e-5);
    EXPECT_TRUE(std::isfinite(view.visible().low.x));
}

TEST(PlanView, zoomByNonsenseChangesNothing) {
    PlanView view = viewOf(300, 200);
    const PlanView before = view;
    for (const double factor : {0.0, -1.0, std::nan(""), HUGE_VAL}) view.zoom(factor, {1, 1});
    EXPECT_EQ(view, before);
}

TEST(PlanView, panMovesWhatIsShownWithThePointer) {
    PlanView view = viewOf(300, 200);
    const auto place = view.toMap({50, 60});
    view.pan(30, -20);
    expectNear(view.toMap({80, 40}), place);
}

TEST(PlanView, anotherSizeKeepsTheMiddle) {
    PlanView view = viewOf(300, 200);
    view.centreOn({7, -8});
    view.setSize(100, 500);
    expectNear(view.toMap({50, 250}), {7, -8});
}

TEST(PlanView, fitToASinglePlaceShowsAMetre) {
    PlanView view = viewOf(100, 100);
    view.fit({{5, 5}, {5, 5}});
    EXPECT_NEAR(view.scale(), 88, rounding);
}

TEST(PlanView, fitToWhatIsNotFiniteChangesNothing) {
    PlanView view = viewOf(100, 100);
    const PlanView before = view;
    view.fit({{-HUGE_VAL, 0}, {5, 5}});
    view.fit({{0, std::nan("")}, {5, 5}});
    EXPECT_EQ(view, before);
}

TEST(Clipped, lineThroughTheRectangleEndsAtItsSides) {
    const auto part = clipped({{-10, 5}, {30, 5}}, {{0, 0}, {20, 10}});
    ASSERT_TRUE(part);
    expectNear(part->point1, {0, 5});
    expectNear(part->point2, {20, 5});
}

TEST(Clipped, lineWithinIsWhole) {
    const auto part = clipped({{1, 2}, {3, 4}}, {{0, 0}, {20, 10}});
    ASSERT_TRUE(part);
    expectNear(part->point1, {1, 2});
    expectNear(part->point2, {3, 4});
}

TEST(Clipped, slantedLinePastACornerIsNone) {
    // x + y = 11 misses the corner (5, 5), which both of its boxes have in common.
    EXPECT_FALSE(clipped({{2, 9}, {9, 2}}, {{0, 0}, {5, 5}}));
}

TEST(Clipped, parallelLineOutsideIsNone) {
    EXPECT_FALSE(clipped({{1, 11}, {3, 11}}, {{0, 0}, {20, 10}}));
    EXPECT_FALSE(clipped({{-1, 0}, {-1, 5}}, {{0, 0}, {20, 10}}));
}

TEST(Clipped, lineThatEndsBeforeTheRectangleIsNone) {
    EXPECT_FALSE(clipped({{-9, 5}, {-1, 5}}, {{0, 0}, {20, 10}}));
}

TEST(Clipped, lineFromFarAwayKeepsItsPlace) {
    const auto part = clipped({{-1e7, 5}, {1e7, 5}}, {{0, 0}, {20, 10}});
    ASSERT_TRUE(part);
    // A double holds 1e7 to 2e-9.
    EXPECT_NEAR(part->point1.x, 0, 4e-9);
    EXPECT_NEAR(part->point2.x, 20, 4e-9);
}

}  // namespace offmap::window
