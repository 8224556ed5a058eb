// SPDX-License-Identifier: BSD-3-Clause
#include "SmallRoom.h"

#include <offmap/core/ScanAlignment.h>
#include <offmap/core/VerticalSegments.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <memory>

namespace offmap::core {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose3D;

namespace {

Eigen::Matrix3d statedCovariance(double position, double headingDeg) {
    const double heading = mrpt::DEG2RAD(headingDeg);
    return Eigen::Vector3d(position * position, position * position, heading * heading)
        .asDiagonal();
}

/// The room of roomWithTwo(), seen from where the sensor truly is; its columns carry another pose.
struct WrongPose {
    explicit WrongPose(const CPose3D& truth, const CPose3D& stated,
                       std::span<const test::Slab> slabs = test::SmallRoom::slabs())
        : built(test::ScanBuilder(slabs, truth).build({})),
          pivot(stated.x(), stated.y()),
          error(stated.x() - truth.x(), stated.y() - truth.y(), stated.yaw() - truth.yaw()) {
        for (ScanColumn& column : built.scan.columns) {
            column.sensor = SensorPose{stated, Eigen::Matrix3d::Zero()};
        }
        level(built.scan, levelled);
        VerticalSegmentFinder({}).find(built.scan, levelled, segments);
        addPlaces(built.scan, places);
        findSights(built.scan, levelled, places, segments, sights);
    }

    Alignment alignTo(const LineMap& map, const Eigen::Matrix3d& stated) const {
        AlignmentScratch scratch;
        return align(sights, map, pivot, stated, {}, scratch);
    }

    test::BuiltScan built;
    TPoint2D pivot;
    Eigen::Vector3d error;
    LevelledScan levelled;
    std::vector<VerticalSegment> segments;
    std::vector<ColumnPlace> places;
    std::vector<WallSight> sights;
};

LineMap roomMap(double sigma = 0.01) {
    auto walls = test::wallsOf(std::span(test::SmallRoom::slabs()).first(test::mappedSlabs));
    for (Wall& wall : walls) wall.sigma = sigma;
    return LineMap(walls);
}

const CPose3D truth(0.4, -0.3, 1.1, 0.2, 0, 0);

}  // namespace

// Scans of the builder have no noise: what is left is what the Gauss-Newton steps leave.
TEST(ScanAlignment, findsAPoseThatIsOffByTheStatedError) {
    const CPose3D stated(0.48, -0.22, 1.1, 0.2 + mrpt::DEG2RAD(3.0), 0, 0);
    const WrongPose scan(truth, stated);
    const Alignment alignment = scan.alignTo(roomMap(), statedCovariance(0.05, 2));
    EXPECT_TRUE(alignment.converged);
    EXPECT_GT(alignment.fittedShare, 0.7) << "two of the slabs are not on the map";
    EXPECT_FALSE(alignment.contradictsPrior());
    EXPECT_NEAR(alignment.correction.mean[0], -scan.error[0], 0.005);
    EXPECT_NEAR(alignment.correction.mean[1], -scan.error[1], 0.005);
    EXPECT_NEAR(alignment.correction.mean[2], -scan.error[2], mrpt::DEG2RAD(0.1));
}

TEST(ScanAlignment, findsTheLeanOfTheMounting) {
    const CPose3D leaning(0.4, -0.3, 1.1, 0.2, mrpt::DEG2RAD(1.5), mrpt::DEG2RAD(-1.0));
    const WrongPose scan(leaning, truth);
    const Alignment alignment = scan.alignTo(roomMap(), statedCovariance(0.03, 0.5));
    ASSERT_TRUE(alignment.converged);
    EXPECT_NEAR(alignment.correction.mean[3], mrpt::DEG2RAD(-1.0), mrpt::DEG2RAD(0.2));
    EXPECT_NEAR(alignment.correction.mean[4], mrpt::DEG2RAD(1.5), mrpt::DEG2RAD(0.2));
}

TEST(ScanAlignment, believesTheScanWhereThePriorIsTooSureOfItself) {
    const CPose3D stated(0.9, -0.3, 1.1, 0.2, 0, 0);  // off by 0.5 m, 10 stated sigmas
    const WrongPose scan(truth, stated);
    const Alignment alignment = scan.alignTo(roomMap(), statedCovariance(0.05, 1));
    ASSERT_TRUE(alignment.converged);
    EXPECT_TRUE(alignment.contradictsPrior());
    EXPECT_NEAR(alignment.correction.mean[0], -0.5, 0.01);
}

TEST(ScanAlignment, fitsBadlyWhereTheRobotIsElsewhere) {
    const CPose3D stated(2.9, 1.5, 1.1, 1.2, 0, 0);
    const WrongPose scan(truth, stated);
    const Alignment alignment = scan.alignTo(roomMap(), statedCovariance(0.03, 0.5));
    EXPECT_FALSE(alignment.fits(AlignmentConfig().minFittedShare));
}

// What stands before walls is no evidence against a pose; what is seen through them is.
TEST(ScanAlignment, fitsByWhatIsOnWallsOrBehindThem) {
    Alignment alignment;
    alignment.converged = true;
    alignment.fittedShare = 0.2;
    alignment.throughShare = 0.1;
    EXPECT_TRUE(alignment.fits(0.5));
    alignment.throughShare = 0.3;
    EXPECT_FALSE(alignment.fits(0.5));
    alignment.fittedShare = 0.05;
    alignment.throughShare = 0;
    EXPECT_FALSE(alignment.fits(0.5)) << "so many are on a wall by chance";
}

TEST(ScanAlignment, seesThroughTheWallsOfAMapThatIsTooSmall) {
    const WrongPose scan(truth, truth);
    auto walls = test::wallsOf(std::span(test::SmallRoom::slabs()).first(test::mappedSlabs));
    const auto right = scan.alignTo(LineMap(walls), statedCovariance(0.03, 0.5));
    EXPECT_LT(right.throughShare, 0.1);
    walls = {{.line = {{0.9, -0.8}, {0.9, 0.2}}}};  // 0.5 m before the sensor
    const auto blocked = scan.alignTo(LineMap(walls), statedCovariance(0.03, 0.5));
    EXPECT_GT(blocked.throughShare, 0.1);
    EXPECT_LT(blocked.fittedShare, 0.1);
}

// Off by 12 degrees and 0.2 m where both are stated to be that uncertain: the walls far away are
// then metres from where the prior has them.
TEST(ScanAlignment, findsAHeadingThatIsHardlyKnown) {
    const CPose3D stated(0.55, -0.15, 1.1, 0.2 + mrpt::DEG2RAD(12.0), 0, 0);
    const WrongPose scan(truth, stated);
    const Alignment alignment = scan.alignTo(roomMap(), statedCovariance(0.15, 8));
    ASSERT_TRUE(alignment.converged);
    EXPECT_NEAR(alignment.correction.mean[2], -mrpt::DEG2RAD(12.0), mrpt::DEG2RAD(0.1));
    EXPECT_FALSE(alignment.contradictsPrior());
}

// Two parallel walls say nothing of the place along them: the prior has to.
TEST(ScanAlignment, keepsThePriorAlongABareCorridor) {
    const std::vector<test::Slab> corridor = {{{{-50, -1}, {50, -1}}}, {{{-50, 1}, {50, 1}}}};
    const CPose3D stated(0.45, -0.25, 1.1, 0.2, 0, 0);
    const WrongPose scan(truth, stated, corridor);
    const LineMap map(test::wallsOf(std::span(corridor)));
    const Alignment alignment = scan.alignTo(map, statedCovariance(0.05, 1));
    ASSERT_TRUE(alignment.converged);
    EXPECT_NEAR(alignment.correction.mean[0], 0, 0.002);
    EXPECT_NEAR(std::sqrt(alignment.correction.covariance(0, 0)), 0.05, 0.002);
    EXPECT_NEAR(alignment.correction.mean[1], -0.05, 0.01);
    EXPECT_LT(std::sqrt(alignment.correction.covariance(1, 1)), 0.03);
}

// The ends of a long corridor are a few sights among many: that the pose is half a metre off along
// it shows in them alone.
TEST(ScanAlignment, doubtsAPoseThatOnlyTheEndsOfACorridorContradict) {
    const std::vector<test::Slab> corridor = {
        {{{-9, -1}, {9, -1}}}, {{{-9, 1}, {9, 1}}}, {{{-9, -1}, {-9, 1}}}, {{{9, -1}, {9, 1}}}};
    const CPose3D along(0, 0, 1.1, 0.2, 0, 0), stated(0.5, 0, 1.1, 0.2, 0, 0);
    const LineMap map(test::wallsOf(std::span(corridor)));
    const auto wrong = WrongPose(along, stated, corridor).alignTo(map, statedCovariance(0.03, 0.5));
    EXPECT_TRUE(wrong.contradictsPrior());
    const auto right = WrongPose(along, along, corridor).alignTo(map, statedCovariance(0.03, 0.5));
    EXPECT_FALSE(right.contradictsPrior());
}

// Turning world and pose together changes nothing in the vehicle's own axes.
TEST(ScanAlignment, doesNotDependOnTheMapsAxes) {
    const CPose3D turn(0, 0, 0, 0.8, 0, 0), stated(0.45, -0.27, 1.1, 0.22, 0, 0);
    auto slabs = test::SmallRoom::slabs();
    auto walls = test::wallsOf(std::span(slabs).first(test::mappedSlabs));
    const Alignment here =
        WrongPose(truth, stated).alignTo(LineMap(walls), statedCovariance(0.05, 1));
    const auto turned = [&](TPoint2D& p) {
        const auto q = turn + mrpt::poses::CPose3D(p.x, p.y, 0, 0, 0, 0);
        p = {q.x(), q.y()};
    };
    for (auto& slab : slabs) {
        turned(slab.line.point1);
        turned(slab.line.point2);
    }
    for (Wall& wall : walls) {
        turned(wall.line.point1);
        turned(wall.line.point2);
    }
    const Alignment there = WrongPose(turn + truth, turn + stated, slabs)
                                .alignTo(LineMap(walls), statedCovariance(0.05, 1));
    const double c = std::cos(0.8), s = std::sin(0.8);
    const Vector5& a = here.correction.mean;
    const Vector5& b = there.correction.mean;
    // The two scans differ by the rounding of points to single precision, some 1e-7 m.
    EXPECT_NEAR(b[0], c * a[0] - s * a[1], 1e-4);
    EXPECT_NEAR(b[1], s * a[0] + c * a[1], 1e-4);
    EXPECT_NEAR(b[2], a[2], 1e-4);
    EXPECT_EQ(here.fittedShare, there.fittedShare);
}

TEST(ScanAlignment, withoutSightsFitsNothing) {
    AlignmentScratch scratch;
    const Alignment alignment =
        align({}, roomMap(), {0, 0}, statedCovariance(0.05, 1), {}, scratch);
    EXPECT_EQ(alignment.fittedShare, 0);
}

}  // namespace offmap::core
