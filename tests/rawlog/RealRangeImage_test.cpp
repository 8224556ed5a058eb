// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"
#include "../support/Scans.h"

#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/RangeImage.h>
#include <offmap/rawlog/RangeImageScan.h>
#include <offmap/rawlog/TurnReducer.h>

#include <gtest/gtest.h>

namespace offmap::rawlog {
namespace {

using test::DepthImage;

/// MRPT's sample: a bookcase before a wall. The camera looks up by 10 degrees, which its sensor
/// pose (the origin) does not tell; a plane through the wall above the bookcase has the normal
/// (0.981, -0.084, -0.177) and the distance 2.16 m, and the wall's points spread by 2 cm about it.
class RealRangeImage : public testing::Test {
 protected:
    /// Where the wall is in the image: above the bookcase, to the left of the room's corner.
    static constexpr size_t wallRows = 130, wallColumns = 580;
    static constexpr double frontDepth = 2.0;  // [m] along the normal: 16 cm in front of the wall

    struct Removed {
        size_t wall = 0, ofWall = 0;    ///< returns
        size_t front = 0, ofFront = 0;  ///< of all that stands clear of the wall
    };

    Removed reduce(const Config& config) const {
        // The plane where it meets the height of the camera, levelled.
        const core::LineMap map({{{{2.10, -0.95}, {2.33, 1.75}}, 0.03}});
        const FixedPose pose({0, 0, 0}, 0.02, mrpt::DEG2RAD(0.5));
        TurnReducer reducer(map, pose, config, OutputClass::Same);
        const ReducedTurn turn = reducer.reduce({obs_}, RangeImageScan());
        const RangeImage image(*obs_);
        Removed removed;
        for (size_t pixel = 0; pixel < image.pixels(); ++pixel) {
            if (image.steps(pixel) == 0) continue;
            const auto point = image.point(0, pixel);
            const double depth = 0.981 * point.x - 0.084 * point.y - 0.177 * point.z;
            const bool gone = turn.removedSlots[pixel] != 0;
            if (pixel / image.columns() < wallRows && pixel % image.columns() < wallColumns) {
                ++removed.ofWall;
                removed.wall += gone;
            } else if (depth < frontDepth) {
                ++removed.ofFront;
                removed.front += gone;
            }
        }
        EXPECT_EQ(removed.ofWall, 63'365U);
        EXPECT_GT(removed.ofFront, 100'000U);
        return removed;
    }

    const std::shared_ptr<DepthImage> obs_ =
        test::observationsIn<DepthImage>("/usr/share/mrpt/datasets/tests_rgbd.rawlog").at(0);
};

TEST_F(RealRangeImage, losesItsWallAlone) {
    Config config;
    config.sensor.mounting = mrpt::poses::CPose3D(0, 0, 1.5, 0, mrpt::DEG2RAD(-10.2), 0);
    const Removed removed = reduce(config);
    EXPECT_GT(removed.wall, removed.ofWall * 95 / 100);  // 97.9 % when written
    EXPECT_EQ(removed.front, 0U);
}

TEST_F(RealRangeImage, keepsTheWallIfItSeemsToLean) {
    // As recorded, the wall leans by 10 degrees: no vertical segment stands on it.
    const Removed removed = reduce({});
    EXPECT_EQ(removed.wall, 0U);
    // Levelled by an angle that is 10 degrees wrong, a scrap of the bookcase may well stand where
    // the map has its wall: less than one return in a hundred (0.55 % when written).
    EXPECT_LT(removed.front, removed.ofFront / 100);

    Config lenient;
    lenient.reduction.vertical.maxTilt = mrpt::DEG2RAD(12.0);
    const Removed more = reduce(lenient);
    EXPECT_GT(more.wall, more.ofWall / 2);  // 73 % when written
    EXPECT_LT(more.front, more.ofFront / 1000);
}

}  // namespace
}  // namespace offmap::rawlog
