// SPDX-License-Identifier: BSD-3-Clause
#include "Pixels.h"
#include "SmallScan.h"

#include <offmap/view/Render.h>
#include <offmap/view/Scene.h>

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::view {
namespace {

constexpr uint32_t width = 400, height = 200;  // [px]
const mrpt::math::TBoundingBox extent{{4, 14, 0}, {16, 26, 2}};

mrpt::img::CImage pictureOf(const SmallScan& s, const Camera& camera, SceneOptions options = {}) {
    const auto returns = placedReturns(s.scan, s.result.labels);
    options.pointSize = 4;
    return render(sceneOf(returns, s.map, extent, options), camera, width, height,
                  options.palette.background);
}

TEST(Render, topViewShowsEachColourWhereItsReturnsStand) {
    const Camera above = Camera::top(extent, 2.0);
    const auto picture = pictureOf({}, above);
    const double scale = height / above.shorterSide;  // [px/m]
    const Palette palette;
    const Pixels mapped = Pixels::of(picture, palette.mapped);
    const Pixels kept = Pixels::of(picture, palette.kept);
    const Pixels rest = Pixels::of(picture, palette.rest);
    // The extent's centre, (10, 20), is the picture's; a pole is one dot, 3 to 4 pixels wide.
    constexpr double tolerance = 1.5;  // [px] half a pixel each of centre, dot and rasterising
    EXPECT_NEAR(mapped.meanX, 0.5 * width - 4 * scale, tolerance);
    EXPECT_NEAR(mapped.meanY, 0.5 * height, tolerance);
    EXPECT_NEAR(kept.meanX, 0.5 * width + 4 * scale, tolerance);
    EXPECT_NEAR(kept.meanY, 0.5 * height, tolerance);
    EXPECT_NEAR(rest.meanX, 0.5 * width, tolerance);
    EXPECT_NEAR(rest.meanY, 0.5 * height - 4 * scale, tolerance);
    for (const Pixels& dot : {mapped, kept, rest}) {
        EXPECT_GE(dot.count, 4);
        EXPECT_LE(dot.count, 25);
    }
}

TEST(Render, wallsAndSensorAreDrawn) {
    const Camera above = Camera::top(extent, 2.0);
    const double scale = height / above.shorterSide;
    const Palette palette;
    const auto picture = pictureOf({}, above);
    const Pixels wall = Pixels::of(picture, palette.wall);
    EXPECT_NEAR(wall.meanY, 0.5 * height + 4 * scale, 1.5);
    EXPECT_NEAR(wall.count, 8 * scale, 0.2 * 8 * scale);  // a line of one pixel; ends may blend
    // The arrow points from the sensor to the map's y: upwards.
    const Pixels arrow = Pixels::of(picture, palette.sensor);
    EXPECT_GT(arrow.count, 3);
    EXPECT_NEAR(arrow.meanX, 0.5 * width, 1.5);
    EXPECT_LT(arrow.meanY, 0.5 * height);
}

TEST(Render, wallsFarFromTheExtentAreLeftOut) {
    SmallScan s;
    s.map = core::LineMap({core::Wall{{{600, 16}, {1400, 16}}}});
    const auto picture = pictureOf(s, Camera::top(extent, 2.0));
    EXPECT_EQ(Pixels::of(picture, Palette{}.wall).count, 0);
}

TEST(Render, perspectiveShowsPolesUprightAndNearOnesLower) {
    const Camera aside =
        Camera::perspective(extent, 2.0, mrpt::DEG2RAD(-90.0), mrpt::DEG2RAD(30.0));
    const Palette palette;
    const auto picture = pictureOf({}, aside);
    const Pixels mapped = Pixels::of(picture, palette.mapped);
    const Pixels kept = Pixels::of(picture, palette.kept);
    const Pixels rest = Pixels::of(picture, palette.rest);
    EXPECT_LT(mapped.meanX, 0.5 * width - 20);
    EXPECT_GT(kept.meanX, 0.5 * width + 20);
    EXPECT_NEAR(mapped.meanX + kept.meanX, width, 3);  // symmetric
    EXPECT_LT(rest.meanY, mapped.meanY - 10);          // further away: higher in the picture
    EXPECT_GT(mapped.count, 11 * 4);                   // eleven dots, not one
}

TEST(Render, wholeExtentFitsFromAnySide) {
    PlacedReturns corners;
    for (const double x : {extent.min.x, extent.max.x})
        for (const double y : {extent.min.y, extent.max.y})
            for (const double z : {extent.min.z, extent.max.z})
                corners.points.emplace_back(mrpt::math::TPoint3D{x, y, z});
    corners.labels.assign(8, core::PointLabel::Kept);
    SceneOptions options;
    options.pointSize = 4;
    for (const double azimuthDeg : {-120.0, 0.0, 77.0}) {
        const Camera aside =
            Camera::perspective(extent, 2.0, mrpt::DEG2RAD(azimuthDeg), mrpt::DEG2RAD(20.0));
        const auto picture = render(sceneOf(corners, core::LineMap({}), extent, options), aside,
                                    width, height, options.palette.background);
        const int count = Pixels::of(picture, options.palette.kept).count;
        EXPECT_GE(count, 8 * 9) << azimuthDeg;  // at least 3 x 3 pixels of each dot
    }
}

}  // namespace
}  // namespace offmap::view
