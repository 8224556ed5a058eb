// SPDX-License-Identifier: BSD-3-Clause
#include "SmallScan.h"

#include <offmap/view/Colouring.h>

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::view {
namespace {

using core::KeepReason;
using mrpt::img::TColor;

/// The small scan, whose first two poles are segments: the first lies on its wall, the second
/// stands 10 standard deviations behind one.
struct Coloured : SmallScan {
    Coloured() {
        for (uint32_t pole : {0U, 1U}) {
            core::VerticalSegment segment{};
            segment.column = pole;
            segment.begin = 11 * pole;
            segment.end = 11 * (pole + 1);
            result.segments.push_back(segment);
        }
        core::SegmentMatch mapped, behind;
        mapped.verdict = core::Verdict::MappedByRay;
        mapped.reason = KeepReason::None;
        mapped.predicted = core::Interval(3.9, 4.1);
        behind.reason = KeepReason::BehindWall;
        behind.predicted = core::Interval(3, 3.1);
        behind.residual = 10;
        result.matches = {mapped, behind};
        returns = placedReturns(scan, result.labels);
    }

    std::vector<TColor> by(ColourBy colourBy, std::span<const float> intensities = {}) const {
        return coloursOf(returns, scan, result, colourBy, palette, intensities);
    }

    PlacedReturns returns;
    Palette palette;
};

TEST(Colouring, byLabelIsThatOfTheFigures) {
    const Coloured scan;
    const auto colours = scan.by(ColourBy::Label);
    ASSERT_EQ(colours.size(), 33U);
    EXPECT_EQ(colours[0], scan.palette.mapped);
    EXPECT_EQ(colours[11], scan.palette.kept);
    EXPECT_EQ(colours[22], scan.palette.rest);
}

TEST(Colouring, byReasonTellsWhyASegmentWasKept) {
    const Coloured scan;
    const auto colours = scan.by(ColourBy::Reason);
    EXPECT_EQ(colours[0], scan.palette.mapped);
    EXPECT_EQ(colours[11], scan.palette.of(KeepReason::BehindWall));
    EXPECT_NE(colours[11], scan.palette.of(KeepReason::InFrontOfWall));
    EXPECT_EQ(colours[22], scan.palette.rest);
}

TEST(Colouring, byResidualIsRedBehindTheWall) {
    const Coloured scan;
    const auto colours = scan.by(ColourBy::Residual);
    EXPECT_EQ(colours[0], diverging(0));
    EXPECT_EQ(colours[11], diverging(1)) << "5 standard deviations and more";
    EXPECT_EQ(colours[22], scan.palette.rest) << "on no segment";
    EXPECT_GT(diverging(1).R, diverging(1).B);
    EXPECT_GT(diverging(-1).B, diverging(-1).R);
}

TEST(Colouring, byHeightRisesAlongAPole) {
    const Coloured scan;
    const auto colours = scan.by(ColourBy::Height);
    EXPECT_EQ(colours[0], sequential(0));
    EXPECT_EQ(colours[10], sequential(1));
    EXPECT_EQ(colours[0], colours[11]) << "the same height";
    EXPECT_NE(colours[3], colours[6]);
}

TEST(Colouring, byIntensityIsGreyWhereThatIsUnknown) {
    const Coloured scan;
    std::vector<float> intensities(33, 0.5F);
    intensities[0] = 0.25F;
    intensities[1] = std::nanf("");
    const auto colours = scan.by(ColourBy::Intensity, intensities);
    EXPECT_EQ(colours[0], sequential(0.5)) << "half as bright as the brightest";
    EXPECT_EQ(colours[2], sequential(1));
    EXPECT_EQ(colours[1], scan.palette.rest);
    EXPECT_EQ(scan.by(ColourBy::Intensity)[0], scan.palette.rest);
}

TEST(Colouring, rangesLeaveOutTheOutermost) {
    PlacedReturns returns;
    for (int i = 0; i < 100; ++i) returns.points.emplace_back(0.0F, 0.0F, static_cast<float>(i));
    returns.points[7].z = std::nanf("");
    // 99 heights: the lowest, 0, and the highest, 99, are left out.
    EXPECT_EQ(colouredHeights(returns), core::Interval(1, 98));
    EXPECT_EQ(colouredHeights({}), core::Interval(0, 0));
    EXPECT_EQ(colouredIntensities({}), core::Interval(0, 1));
    EXPECT_EQ(colouredIntensities(std::vector<float>{0, std::nanf("")}), core::Interval(0, 1));
}

TEST(Colouring, whatIsNoNumberHasAColour) {
    EXPECT_EQ(sequential(std::nan("")), sequential(0));
    EXPECT_EQ(diverging(std::nan("")), diverging(-1));
}

}  // namespace
}  // namespace offmap::view
