// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SensorConfigs.h>

#include <gtest/gtest.h>

#include <utility>

namespace offmap::rawlog {

TEST(SensorConfigs, eachSensorHasItsOwnAndTheOthersTheCommonOne) {
    Config config;
    config.sensor.columnWidth = 0.01;
    config.mountings["top"] = mrpt::math::TPose3D(1, 2, 3, 0, 0, 0);
    SensorConfigs configs(config);
    ASSERT_TRUE(configs.of("top").mounting);
    EXPECT_EQ(configs.of("top").mounting->x(), 1);
    EXPECT_FALSE(configs.of("side").mounting);
    EXPECT_EQ(configs.of("side").columnWidth, 0.01);
}

TEST(SensorConfigs, isPutTogetherOnceAndHoldsWhenMoved) {
    SensorConfigs configs{Config()};
    const SensorConfig& first = configs.of("top");
    configs.of("side");
    EXPECT_EQ(&configs.of("top"), &first);
    SensorConfigs moved(std::move(configs));
    EXPECT_EQ(&moved.of("top"), &first);
}

}  // namespace offmap::rawlog
