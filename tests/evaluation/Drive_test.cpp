// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Drive.h>
#include <offmap/evaluation/SampleWorlds.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

const mrpt::math::TPose2D inOffice{2, 2.5, 0.3};

/// [m] to the nearest surface at half a metre's height, of 720 directions.
double roomAround(const World& world, const mrpt::math::TPose2D& place) {
    double least = 1e9;
    for (int i = 0; i < 720; ++i) {
        const double angle = M_PI * i / 360;
        const auto hit =
            world.castRay({place.x, place.y, 0.45}, {std::cos(angle), std::sin(angle), 0}, 100);
        if (hit) least = std::min(least, hit->range);
    }
    return least;
}

double way(const mrpt::math::TPose2D& a, const mrpt::math::TPose2D& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

TEST(Drive, goesStepByStepThroughFreeSpace) {
    const World world = officeRoom();
    const auto places = placesOnDrive(world, {inOffice, 200, 0.5, {}, 0}, 1);
    ASSERT_EQ(places.size(), 200u);
    EXPECT_EQ(places.front(), inOffice);
    double furthest = 0;
    for (size_t i = 1; i < places.size(); ++i) {
        const double step = way(places[i], places[i - 1]);
        EXPECT_TRUE(std::abs(step - 0.5) < 1e-9 || step == 0) << step;
        EXPECT_GT(roomAround(world, places[i]), 0.3 - 1e-9);
        furthest = std::max(furthest, way(places[i], places.front()));
    }
    EXPECT_GT(furthest, 2) << "it explores the room of 8 x 5 m";
}

TEST(Drive, roomForTheMovementDuringAScanIsLeft) {
    const World world = officeRoom();
    const DrivePlan plan{inOffice, 50, 0.5, {0.5, 0.1}, 2};
    const auto places = placesOnDrive(world, plan, 2);
    ASSERT_EQ(places.size(), 50u);
    for (size_t i = 0; i < places.size(); ++i) {
        const auto end = moved(places[i], plan.whileScanning, plan.scanDuration);
        EXPECT_GT(roomAround(world, end), 0.3 - 1e-9);
        if (i + 1 == places.size()) continue;
        const double step = way(end, places[i + 1]);
        EXPECT_TRUE(std::abs(step - 0.5) < 1e-9 || step < 1e-9) << step;
    }
}

TEST(Drive, isDeterminedByItsSeed) {
    const World world = officeRoom();
    const DrivePlan plan{inOffice, 20, 0.5, {}, 0};
    EXPECT_EQ(placesOnDrive(world, plan, 3), placesOnDrive(world, plan, 3));
    EXPECT_NE(placesOnDrive(world, plan, 3), placesOnDrive(world, plan, 4));
}

TEST(Drive, withoutRoomForAScanIsRefused) {
    const DrivePlan plan{inOffice, 2, 0.5, {10, 0}, 2};  // 20 m in a room of 8 m
    EXPECT_THROW(placesOnDrive(officeRoom(), plan, 1), std::runtime_error);
}

}  // namespace offmap::evaluation
