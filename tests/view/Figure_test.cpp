// SPDX-License-Identifier: BSD-3-Clause
#include "Pixels.h"
#include "SmallScan.h"

#include <offmap/view/Figure.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace offmap::view {
namespace {

FigureOptions smallFigure() {
    FigureOptions options;
    options.width = 900;
    options.height = 400;
    options.title = "a title";
    return options;
}

TEST(Figure, hasTheSizeAskedForAndEveryColour) {
    const SmallScan s;
    const auto figure = figureOf(s.scan, s.result, s.map, smallFigure());
    EXPECT_EQ(figure.getWidth(), 900U);
    EXPECT_EQ(figure.getHeight(), 400U);
    const Palette palette;
    for (const auto& colour : {palette.mapped, palette.kept, palette.rest}) {
        // Beyond the legend's swatch of 13 x 13 pixels there are dots in both panels.
        EXPECT_GT(Pixels::of(figure, colour).count, 13 * 13 + 20);
    }
    EXPECT_GT(Pixels::of(figure, palette.text).count, 100);
}

TEST(Figure, oddSizesAreDrawnToo) {
    const SmallScan s;
    FigureOptions options = smallFigure();
    for (options.width = 899; options.width > 895; --options.width) {
        options.height = options.width / 2;
        const auto figure = figureOf(s.scan, s.result, s.map, options);
        EXPECT_EQ(figure.getWidth(), options.width);
        EXPECT_EQ(figure.getHeight(), options.height);
        EXPECT_GT(Pixels::of(figure, Palette{}.kept).count, 13 * 13 + 20);
    }
}

TEST(Figure, emptyScanGivesAnEmptyPicture) {
    const auto figure = figureOf({}, {}, core::LineMap({}), smallFigure());
    EXPECT_EQ(figure.getWidth(), 900U);
    EXPECT_GT(Pixels::of(figure, Palette{}.background).count, 900 * 400 * 9 / 10);
}

TEST(Figure, tooSmallToHoldItsTextIsRefused) {
    FigureOptions options;
    options.height = 40;
    EXPECT_THROW(figureOf({}, {}, core::LineMap({}), options), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::view
