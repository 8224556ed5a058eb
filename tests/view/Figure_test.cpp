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
        // Beyond the legend's swatch, 10 x 10 pixels at this size, there are dots in both pictures.
        EXPECT_GT(Pixels::of(figure, colour).count, 10 * 10 + 50);
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
        EXPECT_GT(Pixels::of(figure, Palette{}.kept).count, 10 * 10 + 50);
    }
}

TEST(Figure, emptyScanGivesAnEmptyPicture) {
    const auto figure = figureOf({}, {}, core::LineMap({}), smallFigure());
    EXPECT_EQ(figure.getWidth(), 900U);
    EXPECT_GT(Pixels::of(figure, Palette{}.background).count, 900 * 400 * 9 / 10);
}

// The pictures side by side leave 2 px between them, in the colour of the rest: a line as high as
// they are. Returns of the rest are dots of a few pixels.
TEST(Figure, oneViewFillsTheFigure) {
    const SmallScan s;
    FigureOptions options = smallFigure();
    const auto restAt = [&](FigureView view) {
        options.view = view;
        const auto figure = figureOf(s.scan, s.result, s.map, options);
        mrpt::img::CImage middle;
        figure.extract_patch(middle, 900 * 11 / 20, 100, 2, 300);
        return Pixels::of(middle, options.scene.palette.rest).count;
    };
    EXPECT_EQ(restAt(FigureView::Both), 2 * 300);
    EXPECT_LT(restAt(FigureView::Top), 100);
    EXPECT_LT(restAt(FigureView::Perspective), 100);
}

TEST(Figure, hiddenReturnsAreToldButNotDrawn) {
    const SmallScan s;
    FigureOptions options = smallFigure();
    options.scene.showMapped = false;
    const auto figure = figureOf(s.scan, s.result, s.map, options);
    EXPECT_EQ(Pixels::of(figure, options.scene.palette.mapped).count, 10 * 10) << "the legend's";
}

TEST(Figure, posesAreDrawnAndNamed) {
    SmallScan s;
    const Palette palette;
    const auto count = [&](const mrpt::img::TColor& colour) {
        return Pixels::of(figureOf(s.scan, s.result, s.map, smallFigure()), colour).count;
    };
    constexpr int line = 18 * 2;  // [px] of the legend's mark, at this size
    EXPECT_GT(count(palette.sensor), line + 20);
    EXPECT_EQ(count(palette.refined), 0);
    s.result.alignment.emplace().correction.pivot = {10, 20};
    s.result.alignment->correction.mean[0] = 1;  // [m] beside the one that was given
    EXPECT_GT(count(palette.refined), line + 20);
}

TEST(Figure, everyColouringHasItsLegend) {
    const SmallScan s;
    FigureOptions options = smallFigure();
    for (const ColourBy colourBy : {ColourBy::Height, ColourBy::Intensity, ColourBy::Residual}) {
        options.colourBy = colourBy;
        const auto figure = figureOf(s.scan, s.result, s.map, options);
        const auto last = colourBy == ColourBy::Residual ? diverging(1) : sequential(1);
        // The scale's last column at least: 10 px high.
        EXPECT_GE(Pixels::of(figure, last).count, 10) << static_cast<int>(colourBy);
    }
}

TEST(Figure, titleThatIsNoTextIsRefused) {
    FigureOptions options = smallFigure();
    options.title = "\xff\xfe";
    EXPECT_THROW(figureOf({}, {}, core::LineMap({}), options), std::invalid_argument);
}

TEST(Figure, tooSmallToHoldItsTextIsRefused) {
    FigureOptions options;
    options.height = 40;
    EXPECT_THROW(figureOf({}, {}, core::LineMap({}), options), std::invalid_argument);
    options.width = options.height = 180;  // for the legend
    EXPECT_THROW(figureOf({}, {}, core::LineMap({}), options), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::view
