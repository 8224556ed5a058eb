// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"

#include <offmap/rawlog/ImageColumns.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <set>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;

constexpr int imageColumns = 160, imageRows = 120;

CPose3D turned(double yawDegrees, double pitchDegrees, double rollDegrees) {
    return {0.1,
            0.2,
            1.5,
            mrpt::DEG2RAD(yawDegrees),
            mrpt::DEG2RAD(pitchDegrees),
            mrpt::DEG2RAD(rollDegrees)};
}

class ImageColumns : public testing::Test {
 protected:
    void find(const CPose3D& camera) {
        columns_ = findImageColumns(image_, camera);
        rotation_ = camera;
    }

    double elevation(uint32_t pixel) const { return inVehicle(pixel).z / inVehicle(pixel).norm(); }
    double azimuth(uint32_t pixel) const {
        return std::atan2(inVehicle(pixel).y, inVehicle(pixel).x);
    }

    void expectBottomToTop() const {
        for (const ImageColumn& column : columns_) {
            EXPECT_TRUE(std::ranges::is_sorted(column.pixels, {},
                                               [&](uint32_t pixel) { return elevation(pixel); }));
        }
    }

    /// All pixels, each once, and all of a column within `tolerance` [rad] of its azimuth.
    void expectColumns(double tolerance) const {
        std::set<uint32_t> pixels;
        for (const ImageColumn& column : columns_) {
            for (const uint32_t pixel : column.pixels) {
                EXPECT_TRUE(pixels.insert(pixel).second);
                EXPECT_NEAR(mrpt::math::wrapToPi(azimuth(pixel) - column.azimuth), 0, tolerance);
            }
        }
        EXPECT_EQ(pixels.size(), image_.pixels());
    }

    void expectOneWayRound() const {
        size_t up = 0;
        for (size_t c = 1; c < columns_.size(); ++c) {
            up += mrpt::math::wrapToPi(columns_[c].azimuth - columns_[c - 1].azimuth) > 0;
        }
        EXPECT_TRUE(up == 0 || up == columns_.size() - 1) << up;
    }

    const std::shared_ptr<test::DepthImage> obs_ = test::emptyDepthImage(imageColumns, imageRows);
    const RangeImage image_{*obs_};
    std::vector<ImageColumn> columns_;

 private:
    mrpt::math::TVector3D inVehicle(uint32_t pixel) const {
        return rotation_.rotateVector(mrpt::math::TVector3D(image_.rays()[pixel]));
    }

    CPose3D rotation_;
};

/// [rad] What float leaves of the ray's 2^-24, several times.
constexpr double rounding = 1e-6;

TEST_F(ImageColumns, areThoseOfALevelCamera) {
    find(turned(30, 0, 0));
    ASSERT_EQ(columns_.size(), 160U);
    EXPECT_EQ(columns_[7].pixels.front(), 119U * 160 + 7);
    EXPECT_EQ(columns_[7].pixels.back(), 7U);
    // The first column is the leftmost: 29.85 degrees, half a pixel inside the edge at 30.
    EXPECT_NEAR(columns_[0].azimuth,
                mrpt::DEG2RAD(30.0) + std::atan(79.5 / obs_->cameraParams.fx()), rounding);
    expectBottomToTop();
    expectColumns(rounding);
    expectOneWayRound();
}

TEST_F(ImageColumns, standOnTheirHeadWithTheCamera) {
    find(turned(0, 0, 180));
    ASSERT_EQ(columns_.size(), 160U);
    EXPECT_EQ(columns_[7].pixels.front(), 7U);
    expectBottomToTop();
    expectColumns(rounding);
    expectOneWayRound();
}

TEST_F(ImageColumns, areTheRowsOfACameraOnItsSide) {
    for (const double roll : {90.0, -90.0}) {
        find(turned(-20, 0, roll));
        ASSERT_EQ(columns_.size(), 120U);
        EXPECT_EQ(columns_[3].pixels.size(), 160U);
        EXPECT_EQ(columns_[3].pixels.front(), roll > 0 ? 3U * 160 + 159 : 3U * 160);
        expectBottomToTop();
        expectColumns(rounding);
        expectOneWayRound();
    }
}

TEST_F(ImageColumns, ofAnInclinedCameraAreGatheredByAzimuth) {
    for (const auto& camera : {turned(10, 35, 0), turned(0, -20, 40), turned(170, 30, 90)}) {
        find(camera);
        EXPECT_GT(columns_.size(), 100U);
        // Half a column: at most a pixel of 1 / fx seen along 40 degrees of elevation.
        const double onePixel = 1.0 / obs_->cameraParams.fx();
        expectColumns(0.5 * onePixel / std::cos(mrpt::DEG2RAD(40.0)));
    }
}

TEST_F(ImageColumns, stayThoseOfTheImageWhereTheInclinationIsSmall) {
    find(turned(0, 1, 1));
    EXPECT_EQ(columns_.size(), 160U);
    expectColumns(mrpt::DEG2RAD(1.0));
}

TEST_F(ImageColumns, ofACameraThatLooksDownHoldAllPixels) {
    find(turned(0, 90, 0));
    expectColumns(mrpt::DEG2RAD(2.0));
}

}  // namespace
}  // namespace offmap::rawlog
