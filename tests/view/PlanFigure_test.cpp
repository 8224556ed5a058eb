// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "Pixels.h"

#include <offmap/view/PlanFigure.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace offmap::view {
namespace {

const mrpt::img::TColor red(200, 0, 0), green(0, 150, 0), blue(0, 0, 200);

PlanStroke strokeOf(double x1, double y1, double x2, double y2, const mrpt::img::TColor& colour) {
    return {.wall = {.line = {{x1, y1}, {x2, y2}}}, .colour = colour};
}

/// A square of 8 m, each side of another colour than its neighbours.
PlanFigure square() {
    PlanFigure figure;
    figure.title = "a square";
    figure.strokes = {strokeOf(0, 0, 8, 0, red), strokeOf(8, 0, 8, 8, green),
                      strokeOf(8, 8, 0, 8, red), strokeOf(0, 8, 0, 0, green)};
    figure.size = 800;
    return figure;
}

mrpt::img::CImage imageOf(const PlanFigure& figure) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "plan.png", pngOf(figure));
    mrpt::img::CImage image;
    EXPECT_TRUE(image.loadFromFile((folder / "plan.png").string()));
    return image;
}

TEST(PlanFigure, longerSideHasTheSizeAskedFor) {
    PlanFigure figure = square();
    for (const uint32_t size : {200U, 800U, 1601U}) {
        figure.size = size;
        const auto image = imageOf(figure);
        // rounded up to whole pixels
        EXPECT_NEAR(double(std::max(image.getWidth(), image.getHeight())), size, 1);
        EXPECT_GT(std::min(image.getWidth(), image.getHeight()), size / 3);
    }
}

TEST(PlanFigure, wallsStandWhereTheyAre) {
    const auto image = imageOf(square());
    const Pixels reds = Pixels::of(image, red), greens = Pixels::of(image, green);
    // Strokes of 1.5 pixels cover one pixel wholly, or none where they lie across two; the square
    // is at least half as large as the picture.
    EXPECT_GT(reds.count + greens.count, 400);
    EXPECT_GT(reds.right - reds.left, 400);
    EXPECT_GT(greens.bottom - greens.top, 400);
    EXPECT_NEAR(reds.right - reds.left, greens.bottom - greens.top, 4);
}

TEST(PlanFigure, yPointsUp) {
    PlanFigure figure;
    figure.strokes = {strokeOf(0, 0, 8, 0, red), strokeOf(0, 5, 8, 5, green)};
    for (PlanStroke& stroke : figure.strokes) stroke.width = 9;
    const auto image = imageOf(figure);
    EXPECT_LT(Pixels::of(image, green).bottom, Pixels::of(image, red).top);
}

TEST(PlanFigure, arcIsDrawnRound) {
    PlanFigure figure;
    // upper half of a circle of 1 m
    figure.strokes = {
        {.wall = {.line = {{1, 0}, {-1, 0}}, .curvature = 1}, .colour = red, .width = 9}};
    const Pixels pixels = Pixels::of(imageOf(figure), red);
    EXPECT_NEAR(double(pixels.right - pixels.left) / (pixels.bottom - pixels.top), 2, 0.05)
        << "twice as wide as high, but for the width of the stroke";
}

TEST(PlanFigure, bandIsAsWideAsItsWall) {
    PlanFigure figure;
    figure.strokes = {strokeOf(0, 0, 8, 0, blue)};
    figure.strokes[0].band = 1;
    const auto image = imageOf(figure);
    const Pixels wall = Pixels::of(image, blue);
    const Pixels band = Pixels::of(image, {191, 191, 241});
    // 2 m to 8 m, and 1 m of round cap at either end
    EXPECT_NEAR(double(band.bottom - band.top) / double(wall.right - wall.left), 0.25, 0.01);
}

TEST(PlanFigure, svgHasTheColours) {
    PlanFigure figure = square();
    figure.dots = {{{4, 4}, blue}};
    figure.legend = {{"red & blue", red}};
    const std::string svg = svgOf(figure);
    EXPECT_THAT(svg, testing::StartsWith("<?xml"));
    EXPECT_THAT(svg, testing::HasSubstr("</svg>"));
    for (const char* colour : {"78.431373%,0%,0%", "0%,58.823529%,0%", "0%,0%,78.431373%"}) {
        EXPECT_THAT(svg, testing::HasSubstr(colour));
    }
}

TEST(PlanFigure, sameFigureGivesTheSameBytes) { EXPECT_EQ(pngOf(square()), pngOf(square())); }

TEST(PlanFigure, oddPlansAreDrawn) {
    const std::vector<std::vector<PlanStroke>> plans{
        {},
        {strokeOf(3, 3, 3, 3, red)},
        {strokeOf(0, 0, 1e-7, 0, red)},
        {strokeOf(4e6, 5e6, 4e6 + 20, 5e6, red)},
        {strokeOf(-1e9, 0, 1e9, 0, red)},
        {strokeOf(0, 0, 0, 5000, red)},
    };
    for (const auto& plan : plans) {
        PlanFigure figure;
        figure.strokes = plan;
        figure.title = std::string(1000, 'w') + "ü";
        figure.legend.assign(12, {"a layer of a long name", red});
        EXPECT_GT(imageOf(figure).getWidth(), 600U);
    }
}

TEST(PlanFigure, impossibleOnesAreRefused) {
    PlanFigure figure = square();
    figure.size = 199;
    EXPECT_THROW(pngOf(figure), std::invalid_argument);
    figure.size = 20'001;
    EXPECT_THROW(svgOf(figure), std::invalid_argument);
    figure = square();
    figure.strokes.push_back(strokeOf(-1e308, 0, 1e308, 0, red));
    EXPECT_THROW(pngOf(figure), std::invalid_argument);
    figure = square();
    figure.legend.assign(3000, {"a layer", red});
    EXPECT_THROW(pngOf(figure), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::view
