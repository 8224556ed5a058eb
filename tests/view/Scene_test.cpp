// SPDX-License-Identifier: BSD-3-Clause
#include "SmallScan.h"

#include <offmap/core/ArcWalls.h>
#include <offmap/view/Scene.h>

#include <gtest/gtest.h>
#include <mrpt/opengl/CPointCloudColoured.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace offmap::view {
namespace {

// Ends 90 degrees apart at x = 1.41 m; the middle bulges out to 2 m, of which pieces of 0.1 rad
// leave out 2 (1 - cos 0.05) = 2.5 mm.
TEST(Scene, bentWallsBulge) {
    const double quarter = std::numbers::pi / 2;
    const core::LineMap map(core::wallsAlong({{0, 0}, 2, -quarter / 2, quarter}, {}));
    const mrpt::math::TBoundingBox extent({-5, -5, 0}, {5, 5, 3});
    const auto walls = sceneOf({}, map, extent, {})->getByName("walls");
    ASSERT_TRUE(walls);
    const auto box = walls->getBoundingBox();
    EXPECT_NEAR(box.min.x, std::sqrt(2.0), 1e-6) << "single precision";
    EXPECT_NEAR(box.max.x, 2, 0.0026);
    EXPECT_NEAR(box.max.y, std::sqrt(2.0), 1e-6);
    EXPECT_EQ(box.max.z, 3);
}

size_t pointsIn(const mrpt::opengl::CSetOfObjects& set) {
    size_t points = 0;
    for (const auto& object : set) {
        points += std::dynamic_pointer_cast<mrpt::opengl::CPointCloudColoured>(object)->size();
    }
    return points;
}

struct Shown : SmallScan {
    const PlacedReturns returns = placedReturns(scan, result.labels);
    const mrpt::math::TBoundingBox extent = extentOf(returns);
    SceneOptions options;

    mrpt::opengl::CRenderizable::Ptr part(const char* name) const {
        return sceneOf(returns, map, extent, options)->getByName(name);
    }
};

// Three poles of eleven returns: mapped, kept, on no segment.
TEST(Scene, showsWhatIsAskedFor) {
    Shown s;
    EXPECT_EQ(pointsIn(*returnsOf(s.returns, s.options)), 33U);
    EXPECT_TRUE(hiddenReturns(s.returns, s.options).empty());
    s.options.showMapped = false;
    EXPECT_EQ(pointsIn(*returnsOf(s.returns, s.options)), 22U);
    s.options.showRest = false;
    EXPECT_EQ(pointsIn(*returnsOf(s.returns, s.options)), 11U);
    const auto hidden = hiddenReturns(s.returns, s.options);
    ASSERT_EQ(hidden.size(), 33U);
    EXPECT_EQ(hidden[0], 1);
    EXPECT_EQ(hidden[11], 0);
    EXPECT_EQ(hidden[22], 1);
}

TEST(Scene, orphansAreHiddenWithTheMapped) {
    Shown s;
    s.options.showMapped = false;
    EXPECT_FALSE(isShown(core::PointLabel::Orphan, s.options));
    EXPECT_TRUE(isShown(core::PointLabel::Kept, s.options));
    EXPECT_TRUE(isShown(core::PointLabel::NotOnVerticalSegment, s.options));
}

TEST(Scene, partsAreLeftOutOnDemand) {
    Shown s;
    EXPECT_TRUE(s.part("walls"));
    EXPECT_TRUE(s.part("sensor"));
    s.options.showWalls = s.options.showPoses = false;
    EXPECT_FALSE(s.part("walls"));
    EXPECT_FALSE(s.part("sensor"));
    EXPECT_TRUE(s.part("returns"));
}

// A cloud for what is on segments, and one for the rest. MRPT's sets count their first object only.
TEST(Scene, cloudsKnowTheirBounds) {
    Shown s;
    constexpr double single = 1e-5;  // [m] rounding of single precision at 24 m
    const auto bounds = [&](int cloud) {
        return (*std::next(returnsOf(s.returns, s.options)->begin(), cloud))->getBoundingBox();
    };
    EXPECT_NEAR(bounds(0).min.x, 10, single) << "on no segment";
    EXPECT_NEAR(bounds(0).max.y, 24, single);
    EXPECT_NEAR(bounds(1).min.x, 6, single);
    EXPECT_NEAR(bounds(1).max.x, 14, single);
    EXPECT_NEAR(bounds(1).max.z, 2, single);
    s.options.showMapped = false;
    EXPECT_NEAR(bounds(1).min.x, 14, single) << "kept ones only";
}

}  // namespace
}  // namespace offmap::view
