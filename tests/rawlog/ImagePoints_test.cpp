// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"
#include "../support/Scans.h"

#include <offmap/rawlog/ImagePoints.h>
#include <offmap/rawlog/RangeImageScan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

namespace offmap::rawlog {
namespace {

using test::DepthImage;

/// A wall 2 m ahead; every 7th pixel has no return.
DepthImage wallWithPoints(bool organized) {
    auto obs = test::emptyDepthImage(32, 24);
    int pixel = 0;
    test::fillDepths(*obs,
                     [&](const mrpt::math::TVector3D&) { return ++pixel % 7 == 0 ? 0.0 : 2.0; });
    test::storePoints(*obs, organized);
    return *obs;
}

DepthImage reduced(const DepthImage& obs, const std::vector<uint8_t>& keep,
                   Leftovers leftovers = Leftovers::Keep) {
    return dynamic_cast<const DepthImage&>(*RangeImageScan().withOnly(obs, keep, leftovers));
}

/// What is left of the points has to be what MRPT makes of what is left of the image.
void expectPointsInStep(const DepthImage& obs, bool organized) {
    DepthImage again = obs;
    test::storePoints(again, organized);
    EXPECT_EQ(obs.points3D_x, again.points3D_x);
    EXPECT_EQ(obs.points3D_y, again.points3D_y);
    EXPECT_EQ(obs.points3D_z, again.points3D_z);
    if (organized) return;
    EXPECT_EQ(obs.points3D_idxs_x, again.points3D_idxs_x);
    EXPECT_EQ(obs.points3D_idxs_y, again.points3D_idxs_y);
}

TEST(ImagePoints, followTheirPixels) {
    for (const bool organized : {false, true}) {
        const DepthImage obs = wallWithPoints(organized);
        const auto keep = test::randomMask(32 * 24, 7);
        const DepthImage kept = reduced(obs, keep);
        const DepthImage removed = reduced(obs, test::complementOf(keep), Leftovers::Drop);
        ASSERT_EQ(obs.points3D_x.size(), organized ? 32U * 24 : 32U * 24 - 109);
        expectPointsInStep(kept, organized);
        expectPointsInStep(removed, organized);
    }
}

/// Logs of older MRPT have points without indices, or with whatever was in memory.
TEST(ImagePoints, areFoundWithoutTheirIndices) {
    const auto keep = test::randomMask(32 * 24, 8);
    const DepthImage expected = reduced(wallWithPoints(false), keep);
    for (const uint16_t spoiled : std::initializer_list<uint16_t>{0, 5, 60000}) {
        DepthImage obs = wallWithPoints(false);
        std::ranges::fill(obs.points3D_idxs_x, spoiled);
        EXPECT_EQ(reduced(obs, keep).points3D_z, expected.points3D_z);
    }
    DepthImage obs = wallWithPoints(false);
    obs.points3D_idxs_x.clear();
    obs.points3D_idxs_y.clear();
    EXPECT_EQ(reduced(obs, keep).points3D_z, expected.points3D_z);
    const RangeImage image(obs);
    storeIndices(obs, findImagePoints(obs, image), image);
    EXPECT_EQ(obs.points3D_idxs_x, wallWithPoints(false).points3D_idxs_x);
    EXPECT_EQ(obs.points3D_idxs_y, wallWithPoints(false).points3D_idxs_y);
}

TEST(ImagePoints, mayStandInTheFrameOfTheVehicle) {
    DepthImage obs = wallWithPoints(false);
    obs.sensorPose = mrpt::poses::CPose3D(0.5, 0, 1.0, 1.0, 0.2, 0);
    obs.unprojectInto(obs);  // MRPT's own default
    const auto keep = test::randomMask(32 * 24, 9);
    const DepthImage kept = reduced(obs, keep);
    EXPECT_EQ(kept.points3D_idxs_x, reduced(wallWithPoints(false), keep).points3D_idxs_x);
}

TEST(ImagePoints, withoutReturnGoWithTheLeftovers) {
    DepthImage obs = wallWithPoints(false);
    const size_t size = obs.points3D_x.size();
    obs.rangeImage(5, 4) = 0;     // as if a filter had taken the range alone: pixel 164
    ASSERT_EQ(164 % 7, 3);        // it was a return
    obs.points3D_idxs_x[0] = 99;  // beside the image
    const std::vector<uint8_t> all(32 * 24, 1), nothing(32 * 24, 0);
    EXPECT_EQ(reduced(obs, all).points3D_x.size(), size);
    EXPECT_EQ(reduced(obs, nothing).points3D_x.size(), 2U);
    EXPECT_EQ(reduced(obs, all, Leftovers::Drop).points3D_x.size(), size - 2);
    EXPECT_EQ(reduced(obs, nothing, Leftovers::Drop).points3D_x.size(), 0U);
}

TEST(ImagePoints, ofAnotherSceneStayAll) {
    DepthImage obs = wallWithPoints(false);
    for (float& x : obs.points3D_x) x += 3.0F;
    const std::vector<uint8_t> nothing(32 * 24, 0);
    EXPECT_EQ(reduced(obs, nothing).points3D_x.size(), obs.points3D_x.size());
}

TEST(ImagePoints, ofAnotherLayerFollowIt) {
    DepthImage obs = wallWithPoints(false);
    obs.rangeImageOtherLayers["LAST"] = obs.rangeImage;
    obs.rangeImage.fill(500);
    std::vector<uint8_t> keep(2 * 32 * 24, 1);
    keep[0] = 0;
    keep[32 * 24 + 1] = 0;
    const DepthImage kept = reduced(obs, keep);
    EXPECT_EQ(kept.points3D_x.size(), obs.points3D_x.size() - 1);
    EXPECT_EQ(kept.points3D_idxs_x[0], 0);
    EXPECT_EQ(kept.points3D_idxs_x[1], 2);
}

TEST(ImagePoints, aloneAndOnePerPixelBecomeTheOrigin) {
    DepthImage obs = wallWithPoints(true);
    obs.hasRangeImage = false;
    const auto keep = test::randomMask(32 * 24, 11);
    const DepthImage kept = reduced(obs, keep);
    ASSERT_EQ(kept.points3D_x.size(), keep.size());
    for (size_t i = 0; i < keep.size(); ++i) {
        EXPECT_EQ(kept.points3D_x[i], keep[i] ? obs.points3D_x[i] : 0.0F);
    }
}

}  // namespace
}  // namespace offmap::rawlog
