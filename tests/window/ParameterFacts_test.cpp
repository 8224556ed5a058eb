// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterFacts.h"

#include <offmap/rawlog/ParameterTable.h>

#include <gtest/gtest.h>

#include <set>

namespace offmap::window {

namespace {

const rawlog::Parameter& parameter(std::string_view key) { return rawlog::findParameter(key); }

bool isNumeric(const rawlog::Parameter& p) {
    return p.kind == rawlog::ParameterKind::Number || p.kind == rawlog::ParameterKind::Count;
}

}  // namespace

TEST(ParameterFacts, namesLoseSectionAndUnit) {
    EXPECT_EQ(nameOf(parameter("vertical.max_tilt_deg")), "max tilt");
    EXPECT_EQ(nameOf(parameter("sensor.max_column_pause_s")), "max column pause");
    EXPECT_EQ(nameOf(parameter("matching.method")), "method");
}

TEST(ParameterFacts, namesOfASectionDiffer) {
    std::set<std::pair<std::string_view, std::string>> seen;
    for (const auto& p : rawlog::parameters()) {
        // pose.sigma_m and pose.sigma_deg are told apart by their units
        EXPECT_TRUE(seen.emplace(sectionOf(p), nameOf(p) + std::string(p.unit)).second) << p.key;
    }
}

TEST(ParameterFacts, eachSectionHasAHeadingOfItsOwn) {
    for (const auto& p : rawlog::parameters()) {
        EXPECT_NE(headingOf(sectionOf(p)), sectionOf(p)) << p.key;
    }
}

TEST(ParameterFacts, aParameterIsFoundByWordsOfKeyNameAndMeaning) {
    const auto& tilt = parameter("vertical.max_tilt_deg");
    for (const char* text : {"", "  ", "tilt", "Max TILT", "max_tilt", "leans", "tilt vertical"}) {
        EXPECT_TRUE(isFoundBy(tilt, text)) << text;
    }
    EXPECT_FALSE(isFoundBy(tilt, "gap"));
    EXPECT_FALSE(isFoundBy(tilt, "tilt gap"));
}

TEST(ParameterFacts, whatIsReadWithLogOrMapDoesNotActAtOnce) {
    for (const char* key : {"map.sigma_m", "pose.max_age_s", "odometry.heading_per_metre_deg",
                            "sensor.columns_per_turn"}) {
        EXPECT_FALSE(actsAtOnce(parameter(key))) << key;
        EXPECT_NE(hintOf(parameter(key)).find("opened"), std::string::npos) << key;
    }
    for (const char* key : {"matching.method", "sensor.min_range_m", "orphan.remove"}) {
        EXPECT_TRUE(actsAtOnce(parameter(key))) << key;
        EXPECT_EQ(hintOf(parameter(key)).find("opened"), std::string::npos) << key;
    }
}

TEST(ParameterFacts, hintSaysMeaningLimitsDefaultAndKey) {
    EXPECT_EQ(hintOf(parameter("vertical.min_points")),
              "Segments of fewer returns are not used\n"
              "Allowed: a whole number, 2 ... 10000\n"
              "Default: 4\n"
              "Key: vertical.min_points\n"
              "Arrow keys and wheel: steps of 1, with Shift of 10");
}

TEST(ParameterFacts, stepsArePowersOfTenBelowTheDefault) {
    EXPECT_DOUBLE_EQ(stepOf(parameter("vertical.max_tilt_deg")), 1);            // of 5
    EXPECT_DOUBLE_EQ(stepOf(parameter("vertical.max_point_to_line_m")), 0.01);  // of 0.05
    EXPECT_DOUBLE_EQ(stepOf(parameter("alignment.sigma_range_m")), 0.001);      // of 0.02
    EXPECT_DOUBLE_EQ(stepOf(parameter("alignment.gate_sigmas")), 1);            // of 3
    EXPECT_DOUBLE_EQ(stepOf(parameter("matching.max_range_m")), 10);            // of 100
    EXPECT_DOUBLE_EQ(stepOf(parameter("vertical.min_points")), 1);              // of 4
    EXPECT_DOUBLE_EQ(stepOf(parameter("extension.max_column_gap")), 1);         // of 2
    EXPECT_DOUBLE_EQ(stepOf(parameter("sensor.columns_per_turn")), 1);          // of 0
    EXPECT_DOUBLE_EQ(stepOf(parameter("sensor.min_range_m")), 0.1);             // of 0 ... 100
}

TEST(ParameterFacts, steppingStaysOnWholeStepsAndInLimits) {
    const auto& tilt = parameter("vertical.max_tilt_deg");  // 0.1 ... 45
    EXPECT_EQ(stepped(tilt, "5", 1), "6");
    EXPECT_EQ(stepped(tilt, "5.3", 1), "6");
    EXPECT_EQ(stepped(tilt, "5", -10), "0.1");
    EXPECT_EQ(stepped(tilt, "44.5", 10), "45");
    EXPECT_EQ(stepped(tilt, "much", 1), "5");
    EXPECT_EQ(stepped(tilt, "nan", 1), "5");
    EXPECT_EQ(stepped(parameter("vertical.max_point_to_line_m"), "0.05", 2), "0.07");
    EXPECT_EQ(stepped(parameter("vertical.min_points"), "4", -10), "2");
}

TEST(ParameterFacts, everyStepFromTheDefaultIsAllowedAndMoves) {
    for (const auto& p : rawlog::parameters()) {
        if (!isNumeric(p)) continue;
        rawlog::Config config;
        const std::string before = p.text(config);
        p.setText(config, stepped(p, before, 1));
        EXPECT_NE(p.text(config), before) << p.key;
        EXPECT_FALSE(isDefault(p, config)) << p.key;
        p.setText(config, stepped(p, p.text(config), -1));
        EXPECT_EQ(p.text(config), before) << p.key;
    }
}

}  // namespace offmap::window
