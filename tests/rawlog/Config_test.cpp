// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Config.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

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

TEST(Config, enumerationBeyondItsValuesIsRefused) {
    Config config;
    config.sensor.poseReference = static_cast<PoseReference>(3);
    EXPECT_THROW(config.validate(), std::invalid_argument);
}

}  // namespace offmap::rawlog
