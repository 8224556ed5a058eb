// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/SensorSettings.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace offmap::rawlog {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string errorOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

std::vector<std::string> apply(Config& config, const std::string& yaml) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "own.yaml", yaml);
    return applyYaml(config, folder / "own.yaml");
}

std::string errorOfText(const std::string& yaml) {
    Config config;
    std::string error = errorOf([&] { apply(config, yaml); });
    EXPECT_TRUE(config.sensors.empty()) << yaml;
    return error;
}

std::string errorOfSetting(const std::string& setting) {
    Config config;
    std::string error = errorOf([&] { applySetting(config, setting); });
    EXPECT_TRUE(config.sensors.empty()) << setting;
    return error;
}

}  // namespace

TEST(SensorKey, labelReachesFromTheFirstToTheLastDot) {
    EXPECT_EQ(sensorKey("sensors.LIDAR.min_range_m")->label, "LIDAR");
    EXPECT_EQ(sensorKey("sensors.LIDAR.min_range_m")->name, "min_range_m");
    EXPECT_EQ(sensorKey("sensors.a.b.c.min_range_m")->label, "a.b.c");
    EXPECT_EQ(sensorKey("sensors..min_range_m")->label, "");
    EXPECT_FALSE(sensorKey("sensor.min_range_m"));
    EXPECT_THROW(sensorKey("sensors.min_range_m"), std::invalid_argument);
}

TEST(SensorSettings, goOverTheSettingsOfAllInWhateverOrder) {
    const std::string ofAll = "sensor.min_range_m=0.2", ofLeft = "sensors.LEFT.min_range_m=0.5";
    for (const auto& order : {std::vector{ofAll, ofLeft}, std::vector{ofLeft, ofAll}}) {
        Config config;
        for (const std::string& setting : order) applySetting(config, setting);
        EXPECT_EQ(config.sensorOf("LEFT").minRange, 0.5);
        EXPECT_EQ(config.sensorOf("RIGHT").minRange, 0.2);
    }
}

TEST(SensorSettings, laterOneOfTheSameSensorWins) {
    Config config;
    applySetting(config, "sensors.LEFT.min_range_m=0.5");
    applySetting(config, "sensors.LEFT.min_range_m = 0.6");
    applySetting(config, "sensors.LEFT.columns_per_turn=90");
    EXPECT_EQ(config.sensorOf("LEFT").minRange, 0.6);
    EXPECT_EQ(config.sensorOf("LEFT").columnsPerTurn, 90U);
}

TEST(SensorSettings, standInYamlUnderTheirLabels) {
    Config config;
    EXPECT_THAT(apply(config,
                      "sensors:\n  LEFT:\n    min_range_m: 0.5\n    elevations_deg: [-1, 1]\n"
                      "  a.b: {pose_reference: turn}\n  NONE:\nsensor: {min_range_m: 0.2}\n"),
                ElementsAre("sensors.LEFT.min_range_m", "sensors.LEFT.elevations_deg",
                            "sensors.a.b.pose_reference", "sensor.min_range_m"));
    EXPECT_EQ(config.sensorOf("LEFT").minRange, 0.5);
    EXPECT_EQ(config.sensorOf("LEFT").elevations.size(), 2U);
    EXPECT_EQ(config.sensorOf("a.b").poseReference, PoseReference::Turn);
    EXPECT_EQ(config.sensorOf("a.b").minRange, 0.2);
}

TEST(SensorSettings, emptySectionSetsNothing) {
    Config config;
    EXPECT_TRUE(apply(config, "sensors:\n").empty());
    EXPECT_TRUE(apply(config, "sensors: {}\n").empty());
    EXPECT_TRUE(config.sensors.empty());
}

TEST(SensorSettings, labelMayHoldAnEqualsSign) {
    Config config;
    applySetting(config, "sensors.a=b.min_range_m=0.5");
    EXPECT_EQ(config.sensorOf("a=b").minRange, 0.5);
}

TEST(SensorSettings, unknownNameSuggestsTheNearestOfASensor) {
    EXPECT_THAT(errorOfSetting("sensors.LEFT.min_rang=0.5"),
                AllOf(HasSubstr("sensors.LEFT.min_rang"), HasSubstr("did you mean min_range_m?")));
    // vertical.max_gap_m would be the nearest of all.
    EXPECT_THAT(errorOfSetting("sensors.LEFT.max_gap_m=0.5"),
                AllOf(HasSubstr("no key \"max_gap_m\""), testing::Not(HasSubstr("vertical"))));
    EXPECT_THAT(errorOfText("sensors:\n  LEFT:\n    min_rang: 0.5\n"),
                AllOf(HasSubstr("own.yaml:3:"), HasSubstr("did you mean min_range_m?")));
    EXPECT_THAT(errorOfText("sensors: {LEFT: {b.min_range_m: 0.5}}\n"), HasSubstr("no key"));
}

TEST(SensorSettings, wrongValueIsRefusedWhenItIsSet) {
    EXPECT_THAT(errorOfSetting("sensors.LEFT.min_range_m=far"), HasSubstr("0 ... 100 m"));
    EXPECT_THAT(errorOfSetting("sensors.LEFT.min_range_m=-1"), HasSubstr("0 ... 100 m"));
    EXPECT_THAT(errorOfSetting("sensors.LEFT.robot_box_m=1,0,0,1,0,1"),
                HasSubstr("min less than its max"));
    EXPECT_THAT(errorOfText("sensors:\n  LEFT:\n    min_range_m: [1]\n"),
                AllOf(HasSubstr("own.yaml:3:"), HasSubstr("one value")));
    EXPECT_THAT(errorOfText("sensors: {LEFT: {min_range_m: -1}}\n"), HasSubstr("0 ... 100 m"));
}

TEST(SensorSettings, keyWithoutALabelIsRefused) {
    EXPECT_THAT(errorOfSetting("sensors.min_range_m=0.5"), HasSubstr("sensors.LABEL.min_range_m"));
    for (const char* yaml : {"sensors: {min_range_m: 0.5}\n", "sensors: 3\n", "sensors: []\n",
                             "sensors: [LEFT]\n", "sensors: {LEFT: [min_range_m]}\n"}) {
        EXPECT_THAT(errorOfText(yaml), HasSubstr("stand under their labels")) << yaml;
    }
}

TEST(SensorSettings, repeatedLabelOrNameIsRefused) {
    EXPECT_THAT(errorOfText("sensors:\n  A: {min_range_m: 1}\n  A: {min_range_m: 1}\n"),
                AllOf(HasSubstr("own.yaml:3:"), HasSubstr("second time")));
    EXPECT_THAT(errorOfText("sensors: {A: {min_range_m: 1, min_range_m: 1}}\n"),
                HasSubstr("second time"));
}

}  // namespace offmap::rawlog
