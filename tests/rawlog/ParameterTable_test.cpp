// SPDX-License-Identifier: BSD-3-Clause
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
using testing::HasSubstr;

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
        for (const double limit : {p.min, p.max}) {
            Config config;
            p.setNumber(config, limit);
            EXPECT_NO_THROW(config.validate()) << p.key << " = " << limit;
        }
    }
}

TEST(ParameterTable, setChangesNothingElse) {
    for (const Parameter& changed : parameters()) {
        Config config;
        const double value = changed.number(config) == changed.max ? changed.min : changed.max;
        changed.setNumber(config, value);
        for (const Parameter& p : parameters()) {
            if (p.key == changed.key) {
                EXPECT_NEAR(p.number(config), value, 1e-15 * value) << p.key;
            } else {
                EXPECT_EQ(p.number(config), p.number(Config{})) << changed.key << ", " << p.key;
            }
        }
    }
}

TEST(ParameterTable, beyondItsLimitsIsRefused) {
    for (const Parameter& p : parameters()) {
        for (const double value : {p.min - 1, p.max + 1, std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity()}) {
            Config config;
            EXPECT_THAT(errorOf([&] { p.setNumber(config, value); }),
                        AllOf(HasSubstr(p.key), HasSubstr(p.allowed())));
            EXPECT_EQ(p.number(config), p.number(Config{})) << p.key;
        }
    }
}

TEST(ParameterTable, textIsReadBackToTheSameValue) {
    for (const Parameter& p : parameters()) {
        for (const double limit : {p.min, p.max}) {
            Config written;
            p.setNumber(written, limit);
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
