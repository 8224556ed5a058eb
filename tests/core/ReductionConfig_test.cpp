// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ReductionConfig.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace offmap::core {

namespace {

std::string messageOf(const ReductionConfig& config) {
    try {
        config.validate();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(ReductionConfig, defaultsAreValid) { EXPECT_EQ(messageOf({}), ""); }

TEST(ReductionConfig, fieldOutOfItsLimitsIsNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    struct Case {
        std::function<void(ReductionConfig&)> spoil;
        std::string message;
    };
    const std::vector<Case> cases{
        {[](auto& c) { c.vertical.maxPointToLine = 0; },
         "vertical.max_point_to_line_m must be > 0"},
        {[&](auto& c) { c.vertical.maxTilt = nan; },
         "vertical.max_tilt_deg must be between 0 and 90"},
        {[](auto& c) { c.vertical.maxTilt = 1.58; },
         "vertical.max_tilt_deg must be between 0 and 90"},
        {[&](auto& c) { c.vertical.maxGap = inf; }, "vertical.max_gap_m must be > 0"},
        {[](auto& c) { c.vertical.minLength = -0.1; }, "vertical.min_length_m must be >= 0"},
        {[](auto& c) { c.vertical.minPoints = 1; }, "vertical.min_points must be at least 2"},
        {[](auto& c) { c.groundInterval.maxMountingTilt = -0.1; },
         "ground_interval.max_mounting_tilt_deg must be from 0 to less than 90"},
        {[&](auto& c) { c.matching.sigmaFactor = nan; }, "matching.sigma_factor must be >= 0"},
        {[](auto& c) { c.matching.maxRange = 0; }, "matching.max_range_m must be > 0"},
        {[](auto& c) { c.matching.maxPositionRadius = -1; },
         "matching.max_position_radius_m must be > 0"},
        {[&](auto& c) { c.matching.maxHeadingError = nan; },
         "matching.max_heading_error_deg must be > 0"},
        {[](auto& c) { c.extension.maxPointToLine = 0; },
         "extension.max_point_to_line_m must be > 0"},
        {[&](auto& c) { c.extension.minLength = inf; }, "extension.min_length_m must be >= 0"},
        {[](auto& c) { c.extension.minSegments = 1; }, "extension.min_segments must be at least 2"},
        {[](auto& c) { c.extension.maxColumnGap = 0; },
         "extension.max_column_gap must be at least 1"},
        {[](auto& c) { c.orphan.neighbourColumns = 0; },
         "orphan.neighbour_columns must be at least 1"},
        {[](auto& c) { c.orphan.maxDistance = 0; }, "orphan.max_distance_m must be > 0"},
    };
    for (const auto& [spoil, message] : cases) {
        ReductionConfig config;
        spoil(config);
        EXPECT_EQ(messageOf(config), message);
    }
}

}  // namespace offmap::core
