// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ParameterValues.h"

#include <offmap/rawlog/ParameterTable.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {

namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;

std::string errorOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace

TEST(ParameterTable, keysAreUnique) {
    std::set<std::string_view> keys;
    for (const Parameter& p : parameters()) EXPECT_TRUE(keys.insert(p.key).second) << p.key;
}

TEST(ParameterTable, keysEndWithTheirUnit) {
    for (const Parameter& p : parameters()) {
        if (p.unit == "-") continue;
        EXPECT_TRUE(p.key.ends_with(std::string("_").append(p.unit))) << p.key;
    }
}

TEST(ParameterTable, everyParameterIsExplained) {
    for (const Parameter& p : parameters()) EXPECT_FALSE(p.meaning.empty()) << p.key;
}

TEST(ParameterTable, defaultsAreAllowed) { EXPECT_NO_THROW(Config{}.validate()); }

// Both ends of every range must suit the stages that use the value, too.
TEST(ParameterTable, limitsAreValid) {
    for (const Parameter& p : parameters()) {
        for (const auto& limits : test::limitsOf(p)) {
            Config config;
            p.setNumbers(config, limits);
            EXPECT_NO_THROW(config.validate()) << p.key << " = " << p.text(config);
        }
    }
}

TEST(ParameterTable, setChangesNothingElse) {
    for (const Parameter& changed : parameters()) {
        Config config;
        const auto values = test::otherThan(changed, changed.numbers(config));
        changed.setNumbers(config, values);
        for (const Parameter& p : parameters()) {
            if (p.key == changed.key) {
                // A degree goes there and back: twice half a unit in the last place.
                EXPECT_THAT(p.numbers(config), Pointwise(DoubleEq(), values)) << p.key;
            } else {
                EXPECT_EQ(p.numbers(config), p.numbers(Config{})) << changed.key << ", " << p.key;
            }
        }
    }
}

TEST(ParameterTable, beyondItsLimitsIsRefused) {
    for (const Parameter& p : parameters()) {
        for (const double value : {p.min - 1, p.max + 1, std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity()}) {
            Config config;
            for (auto values : test::limitsOf(p)) {
                if (values.empty()) continue;
                values.back() = value;
                EXPECT_THAT(errorOf([&] { p.setNumbers(config, values); }),
                            AllOf(HasSubstr(p.key), HasSubstr(p.allowed())));
            }
            EXPECT_EQ(p.numbers(config), p.numbers(Config{})) << p.key;
        }
    }
}

TEST(ParameterTable, textIsReadBackToTheSameValue) {
    for (const Parameter& p : parameters()) {
        for (const auto& limits : test::limitsOf(p)) {
            Config written;
            p.setNumbers(written, limits);
            Config read;
            p.setText(read, p.text(written));
            EXPECT_EQ(p.read(read), p.read(written)) << p.key;
        }
    }
}

TEST(ParameterTable, degreesBecomeRadians) {
    Config config;
    findParameter("vertical.max_tilt_deg").setText(config, "4.5");
    EXPECT_DOUBLE_EQ(config.reduction.vertical.maxTilt, mrpt::DEG2RAD(4.5));
    EXPECT_EQ(findParameter("vertical.max_tilt_deg").text(config), "4.5");
}

TEST(ParameterTable, choiceIsWrittenByName) {
    Config config;
    const Parameter& reference = findParameter("sensor.pose_reference");
    EXPECT_EQ(reference.text(config), "auto");
    reference.setText(config, "column");
    EXPECT_EQ(config.sensor.poseReference, PoseReference::Column);
    EXPECT_THAT(errorOf([&] { reference.setText(config, "Turn"); }),
                HasSubstr("auto, turn, column"));
}

TEST(ParameterTable, switchIsTrueOrFalse) {
    Config config;
    findParameter("orphan.remove").setText(config, "true");
    EXPECT_TRUE(config.reduction.orphan.remove);
    EXPECT_THAT(errorOf([&] { findParameter("orphan.remove").setText(config, "1"); }),
                HasSubstr("true or false"));
}

TEST(ParameterTable, textOfWrongTypeIsRefused) {
    Config config;
    for (const char* text : {"", "abc", "0.05 m", "0,05", "nan", "inf", "1e999"}) {
        EXPECT_THROW(findParameter("map.sigma_m").setText(config, text), std::invalid_argument)
            << text;
    }
    for (const char* text : {"", "4.5", "4.0", "-4", "four", "99999999999999"}) {
        EXPECT_THROW(findParameter("vertical.min_points").setText(config, text),
                     std::invalid_argument)
            << text;
    }
}

TEST(ParameterTable, listIsReadWithAndWithoutBrackets) {
    Config config;
    const Parameter& elevations = findParameter("sensor.elevations_deg");
    EXPECT_EQ(elevations.text(config), "[]");
    for (const char* text : {"[-15, 1.5]", "-15,1.5", "[ -15 ,1.5 ]"}) {
        elevations.setText(config, "[]");
        elevations.setText(config, text);
        EXPECT_THAT(config.sensor.elevations,
                    ElementsAre(DoubleEq(mrpt::DEG2RAD(-15.0)), DoubleEq(mrpt::DEG2RAD(1.5))))
            << text;
        EXPECT_EQ(elevations.text(config), "[-15, 1.5]");
    }
    elevations.setText(config, "7");
    EXPECT_EQ(elevations.text(config), "[7]");
    elevations.setText(config, "[ ]");
    EXPECT_THAT(config.sensor.elevations, IsEmpty());
}

TEST(ParameterTable, listOfWrongEntriesIsRefused) {
    Config config;
    const Parameter& elevations = findParameter("sensor.elevations_deg");
    for (const char* text : {"", "[", "]", "[1", "1]", "1,", ",1", "[,]", "1,,2", "1 2", "up",
                             "[1,up]", "[[1]]", "[1, 91]", "-90.5", "nan", "[0, inf]"}) {
        EXPECT_THAT(errorOf([&] { elevations.setText(config, text); }),
                    AllOf(HasSubstr("sensor.elevations_deg"),
                          HasSubstr("a list of numbers, each -90 ... 90 deg")))
            << text;
    }
    EXPECT_THAT(config.sensor.elevations, IsEmpty());
}

TEST(ParameterTable, boxHasSixSidesOrNone) {
    Config config;
    const Parameter& box = findParameter("sensor.robot_box_m");
    box.setText(config, "-0.5,0.25,-0.3,0.4,0,1.5");
    ASSERT_TRUE(config.sensor.robotBox);
    EXPECT_EQ(config.sensor.robotBox->min, mrpt::math::TPoint3D(-0.5, -0.3, 0));
    EXPECT_EQ(config.sensor.robotBox->max, mrpt::math::TPoint3D(0.25, 0.4, 1.5));
    EXPECT_EQ(box.text(config), "[-0.5, 0.25, -0.3, 0.4, 0, 1.5]");
    for (const char* text : {"1", "-1,1,-1,1,0", "-1,1,-1,1,0,1,2"}) {
        EXPECT_THAT(errorOf([&] { box.setText(config, text); }),
                    HasSubstr("a list of 0 or 6 numbers, each -100 ... 100 m"))
            << text;
    }
    box.setText(config, "[]");
    EXPECT_FALSE(config.sensor.robotBox);
}

TEST(ParameterTable, fractionOfACountIsRefused) {
    Config config;
    EXPECT_THROW(findParameter("vertical.min_points").setNumber(config, 4.5),
                 std::invalid_argument);
}

TEST(FindParameter, slipSuggestsTheNearestKey) {
    EXPECT_THAT(errorOf([] { findParameter("vertical.max_tlit_deg"); }),
                HasSubstr("did you mean vertical.max_tilt_deg?"));
    EXPECT_THAT(errorOf([] { findParameter("verticl.max_tilt"); }),
                HasSubstr("did you mean vertical.max_tilt_deg?"));
    EXPECT_THAT(errorOf([] { findParameter("pose_reference"); }),
                HasSubstr("did you mean sensor.pose_reference?"));
}

TEST(FindParameter, nothingNearSuggestsNothing) {
    for (const char* key : {"xyzzy", ""}) {
        EXPECT_THAT(errorOf([key] { findParameter(key); }),
                    AllOf(HasSubstr("unknown key"), HasSubstr("default.yaml")))
            << key;
    }
}

}  // namespace offmap::rawlog
