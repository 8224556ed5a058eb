// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/DecodedPoints.h>
#include <offmap/rawlog/ScanClasses.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace offmap::rawlog {
namespace {

using mrpt::obs::CObservation;
using Bits = std::array<uint32_t, 3>;

SensorConfig config() {
    SensorConfig config;
    for (const double degrees : test::rotatingElevations()) {  // only a rotating scan looks at them
        config.elevations.push_back(mrpt::DEG2RAD(degrees));
    }
    return config;
}

/// Sorted; to the bit.
std::vector<Bits> decoded(const CObservation& obs) {
    std::vector<Bits> all;
    for (const auto& p : decodedPoints(obs, *scanClassOf(obs, config()), config())) {
        all.push_back({std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y),
                       std::bit_cast<uint32_t>(p.z)});
    }
    std::ranges::sort(all);
    return all;
}

test::Observations oneOfEachClass() {
    test::SimulatedRobot robot;
    return {robot.vlp16(), robot.cloud(), robot.rotatingScan(), robot.sweep().at(7),
            robot.depthCamera()};
}

TEST(DecodedPoints, reducedObservationsDecodeToTheSameBits) {
    for (const auto& obs : oneOfEachClass()) {
        const std::string label = obs->sensorLabel;
        const ScanClass& scanClass = *scanClassOf(*obs, config());
        const auto mask = test::randomMask(scanClass.slotCount(*obs), 5);
        const auto kept = decoded(*scanClass.withOnly(*obs, mask));
        const auto removed =
            decoded(*scanClass.withOnly(*obs, test::complementOf(mask), Leftovers::Drop));
        std::vector<Bits> both;
        std::ranges::merge(kept, removed, std::back_inserter(both));
        EXPECT_GT(kept.size(), 10U) << label;
        EXPECT_GT(removed.size(), 10U) << label;
        EXPECT_EQ(both, decoded(*obs)) << label;
        EXPECT_EQ(decoded(*scanClass.asPointCloud(*obs, mask, config())), kept) << label;
    }
}

TEST(DecodedPoints, whatIsNoReturnIsLeftOut) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    mrpt::obs::CObservationPointCloud cloud;
    cloud.pointcloud = mrpt::maps::CSimplePointsMap::Create();
    EXPECT_TRUE(decoded(cloud).empty());
    cloud.pointcloud->insertPoint(0, 0, 0);
    cloud.pointcloud->insertPoint(nan, 1, 2);
    cloud.pointcloud->insertPoint(1, 2, 3);
    EXPECT_EQ(decoded(cloud).size(), 1U);
}

}  // namespace
}  // namespace offmap::rawlog
