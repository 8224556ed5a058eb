// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ReductionConfig.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace offmap::core {

namespace {

void require(bool holds, const char* field, const char* limits) {
    if (!holds) throw std::invalid_argument(std::string(field) + " must be " + limits);
}

bool positive(double x) { return x > 0 && std::isfinite(x); }
bool notNegative(double x) { return x >= 0 && std::isfinite(x); }

}  // namespace

void ReductionConfig::validate() const {
    constexpr double rightAngle = std::numbers::pi / 2;
    require(positive(vertical.maxPointToLine), "vertical.max_point_to_line_m", "> 0");
    require(vertical.maxTilt > 0 && vertical.maxTilt < rightAngle, "vertical.max_tilt_deg",
            "between 0 and 90");
    require(positive(vertical.maxGap), "vertical.max_gap_m", "> 0");
    require(notNegative(vertical.minLength), "vertical.min_length_m", ">= 0");
    require(vertical.minPoints >= 2, "vertical.min_points", "at least 2");
    require(groundInterval.maxMountingTilt >= 0 && groundInterval.maxMountingTilt < rightAngle,
            "ground_interval.max_mounting_tilt_deg", "from 0 to less than 90");
    require(notNegative(matching.sigmaFactor), "matching.sigma_factor", ">= 0");
    require(positive(matching.maxRange), "matching.max_range_m", "> 0");
    require(positive(matching.maxPositionRadius), "matching.max_position_radius_m", "> 0");
    require(positive(matching.maxHeadingError), "matching.max_heading_error_deg", "> 0");
    require(positive(extension.maxPointToLine), "extension.max_point_to_line_m", "> 0");
    require(notNegative(extension.minLength), "extension.min_length_m", ">= 0");
    require(extension.minSegments >= 2, "extension.min_segments", "at least 2");
    require(extension.maxColumnGap >= 1, "extension.max_column_gap", "at least 1");
    require(orphan.neighbourColumns >= 1, "orphan.neighbour_columns", "at least 1");
    require(positive(orphan.maxDistance), "orphan.max_distance_m", "> 0");
}

}  // namespace offmap::core
