// SPDX-License-Identifier: BSD-3-Clause
#include "PlotsPane.h"

#include "DrawnPicture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::window {

namespace {

using test::spotOf;

/// Three plots of 80 px each over the seconds; their boxes go from 50 px to 284 px.
class PlotsPaneTest : public testing::Test {
 protected:
    wxRect boxOf(int row) const { return {50, 80 * row + 18, 236, 59}; }

    test::PaneOnScreen<PlotsPane> plots_{300, 258};
    const Theme& theme_ = Theme::darkOne();
};

}  // namespace

TEST_F(PlotsPaneTest, curvesStandInTheirPlots) {
    for (int i = 0; i <= 600; ++i) plots_->add(0.1 * i, 0.5, 2.5, 8, 25);
    const wxImage picture = plots_.picture();
    const auto blueAt = [&](int y) {
        return picture.GetBlue(150, y) - picture.GetRed(150, y) > 60;
    };
    // Of 10 ms at most, 2.5 ms stand a quarter high in a box of 57 px: smooth over two rows.
    const int quarter = 80 + 18 + 57 * 3 / 4;
    EXPECT_TRUE(blueAt(quarter) || blueAt(quarter - 1) || blueAt(quarter + 1));
    EXPECT_FALSE(blueAt(quarter - 20));
    const auto redAt = [&](int y) { return picture.GetRed(150, y) - picture.GetBlue(150, y) > 60; };
    const int half = 18 + 57 / 2;
    EXPECT_TRUE(redAt(half) || redAt(half - 1) || redAt(half + 1));
}

TEST_F(PlotsPaneTest, onlyTheLastMinuteIsShown) {
    plots_->add(0, 1, 1, 1, 1);
    for (int i = 0; i < 10; ++i) plots_->add(95 + 0.5 * i, 0.5, 2.5, 8, 25);
    const wxImage picture = plots_.picture();
    // The newest five seconds of sixty are the last 20 px; heads are above the box.
    int leftmost = 300;
    for (int x = 50; x < 284; ++x) {
        for (int y = 30; y < 70; ++y) {
            if (picture.GetRed(x, y) - picture.GetBlue(x, y) > 60) leftmost = std::min(leftmost, x);
        }
    }
    EXPECT_GE(leftmost, 284 - 20);
    EXPECT_LT(leftmost, 284);
}

TEST_F(PlotsPaneTest, aClockThatGoesBackBeginsAnew) {
    for (int i = 0; i < 100; ++i) plots_->add(1000 + 0.1 * i, 0.5, 2.5, 8, 25);
    plots_->add(3, 0.5, 2.5, 8, 25);
    test::PaneOnScreen<PlotsPane> fresh(300, 258);
    fresh->add(3, 0.5, 2.5, 8, 25);
    const wxImage again = plots_.picture(), first = fresh.picture();
    const auto bytes = static_cast<size_t>(3 * 300 * 258);
    EXPECT_TRUE(std::equal(again.GetData(), again.GetData() + bytes, first.GetData()));
}

TEST_F(PlotsPaneTest, withoutValuesOrWithNonsenseIsDrawn) {
    EXPECT_EQ(spotOf(plots_.picture(), theme_.timing, boxOf(1)).count, 0);
    plots_->add(std::nan(""), 1, 1, 1, 1);
    plots_->add(1, std::nan(""), HUGE_VAL, -HUGE_VAL, std::nan(""));
    plots_->add(2, -5, -3, -2, -1);
    EXPECT_EQ(plots_.picture().GetWidth(), 300);
    plots_->clear();
    EXPECT_EQ(spotOf(plots_.picture(), theme_.timing, boxOf(1)).count, 0);
}

TEST_F(PlotsPaneTest, theSmallestPaneIsDrawn) {
    test::PaneOnScreen<PlotsPane> tiny(1, 1);
    tiny->add(1, 0.5, 2.5, 8, 25);
    EXPECT_EQ(tiny.picture().GetWidth(), 1);
}

}  // namespace offmap::window
