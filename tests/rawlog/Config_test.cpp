// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Config.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace offmap::rawlog {

namespace {

std::string errorOf(const Config& config) {
    try {
        config.validate();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace

TEST(Config, eachPartIsValidated) {
    Config reduction;
    reduction.reduction.vertical.maxTilt = -1;
    EXPECT_THAT(errorOf(reduction), testing::HasSubstr("vertical.max_tilt_deg"));

    Config sensor;
    sensor.sensor.maxColumnPause = 0;
    EXPECT_THAT(errorOf(sensor), testing::HasSubstr("sensor.max_column_pause_s"));

    Config pose;
    pose.pose.maxAge = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(errorOf(pose), testing::HasSubstr("pose.max_age_s"));

    Config map;
    map.map.sigma = std::numeric_limits<double>::infinity();
    EXPECT_THAT(errorOf(map), testing::HasSubstr("map.sigma_m"));
}

TEST(Config, whatASingleSensorSetsHoldsForItAlone) {
    Config config;
    config.sensor.minRange = 0.3;
    config.sensor.columnsPerTurn = 90;
    config.sensors["LEFT"] = {{"min_range_m", "0.5"}};
    config.mountings["RIGHT"] = {1, 2, 3, 0, 0, 0};
    EXPECT_EQ(config.sensorOf("LEFT").minRange, 0.5);
    EXPECT_EQ(config.sensorOf("LEFT").columnsPerTurn, 90U);
    EXPECT_FALSE(config.sensorOf("LEFT").mounting);
    EXPECT_EQ(config.sensorOf("RIGHT").minRange, 0.3);
    EXPECT_EQ(config.sensorOf("RIGHT").mounting.value().z(), 3);
    EXPECT_EQ(config.sensorOf("").minRange, 0.3);
}

TEST(Config, wrongSettingOfASingleSensorNamesIt) {
    Config config;
    config.sensors["LEFT"] = {{"min_range_m", "-1"}};
    EXPECT_THAT(errorOf(config), testing::HasSubstr("sensors.LEFT"));
    config.sensors["LEFT"] = {{"robot_box_m", "1,0,0,1,0,1"}};
    EXPECT_THAT(errorOf(config), testing::HasSubstr("sensors.LEFT: sensor.robot_box_m"));
}

TEST(Config, boxWithoutAnInsideIsRefused) {
    for (const std::vector<double>& sides : std::vector<std::vector<double>>{
             {1, 1, 0, 1, 0, 1}, {0, 1, 1, 0, 0, 1}, {0, 1, 0, 1, 0.5, 0.5}}) {
        Config config;
        config.sensor.robotBox =
            RobotBox{{sides[0], sides[2], sides[4]}, {sides[1], sides[3], sides[5]}};
        EXPECT_THAT(errorOf(config), testing::HasSubstr("sensor.robot_box_m"));
    }
}

TEST(Config, enumerationBeyondItsValuesIsRefused) {
    Config config;
    config.sensor.poseReference = static_cast<PoseReference>(3);
    EXPECT_THROW(config.validate(), std::invalid_argument);
}

}  // namespace offmap::rawlog
