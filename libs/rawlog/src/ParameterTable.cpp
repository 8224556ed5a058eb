// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterRows.h"

#include <offmap/rawlog/EditDistance.h>
#include <offmap/rawlog/ParameterTable.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Rows = std::vector<Parameter>;

std::vector<double> sidesOf(const std::optional<RobotBox>& box) {
    if (!box) return {};
    return {box->min.x, box->max.x, box->min.y, box->max.y, box->min.z, box->max.z};
}

std::optional<RobotBox> boxOf(const std::vector<double>& sides) {
    if (sides.empty()) return std::nullopt;
    return RobotBox{{sides.at(0), sides.at(2), sides.at(4)},
                    {sides.at(1), sides.at(3), sides.at(5)}};
}

// clang-format off
#define FIELD(path) ([](auto& c) -> auto& { return c.path; })

Rows segmentRows() {
    return {
        number("vertical.max_point_to_line_m", "m", 0.001, 1, FIELD(reduction.vertical.maxPointToLine),
               "split-and-merge tolerance: a return's distance from its vertical segment"),
        number("vertical.max_tilt_deg", "deg", 0.1, 45, FIELD(reduction.vertical.maxTilt),
               "a segment that leans further than this is not vertical (eta)"),
        number("vertical.max_gap_m", "m", 0.01, 100, FIELD(reduction.vertical.maxGap),
               "between neighbouring returns of a segment; a larger gap splits it"),
        number("vertical.min_length_m", "m", 0, 100, FIELD(reduction.vertical.minLength),
               "shorter segments are not used"),
        count("vertical.min_points", 2, 10000, FIELD(reduction.vertical.minPoints),
              "segments of fewer returns are not used"),

        number("ground_interval.max_mounting_tilt_deg", "deg", 0, 45, FIELD(reduction.groundInterval.maxMountingTilt),
               "how far the sensor may lean without anybody knowing (gamma of eq. 4)"),
    };
}

Rows matchingRows() {
    return {
        choice("matching.method", {"paper", "probabilistic", "aligned"}, FIELD(reduction.matching.method),
               "how segments are matched to the map"),
        number("matching.sigma_factor", "-", 0, 10, FIELD(reduction.matching.sigmaFactor),
               "standard deviations that an uncertainty is taken as"),
        number("matching.max_range_m", "m", 0.1, 10000, FIELD(reduction.matching.maxRange),
               "walls further away are not looked for"),
        number("matching.max_position_radius_m", "m", 0.001, 100, FIELD(reduction.matching.maxPositionRadius),
               "a pose whose position ellipse is larger is not used; aligned: 4 times as large"),
        number("matching.max_heading_error_deg", "deg", 0.01, 90, FIELD(reduction.matching.maxHeadingError),
               "a pose whose heading is less certain is not used; aligned: 4 times that"),
    };
}

Rows alignmentRows() {
    return {
        number("alignment.sigma_range_m", "m", 0.001, 1, FIELD(reduction.alignment.sigmaRange),
               "standard deviation of a single return's range"),
        number("alignment.sigma_tilt_deg", "deg", 0.01, 10, FIELD(reduction.alignment.sigmaTilt),
               "standard deviation of the sensor's lean, about either axis"),
        number("alignment.gate_sigmas", "-", 0.5, 10, FIELD(reduction.alignment.gate),
               "standard deviations that a mapped segment may stand off its wall"),
        number("alignment.min_fitted_share", "-", 0, 1, FIELD(reduction.alignment.minFittedShare),
               "share of the segments on or behind walls that are on them; with fewer, all stay"),
    };
}

Rows extensionAndOrphanRows() {
    return {
        onOff("extension.enabled", FIELD(reduction.extension.enabled),
              "extend matched segments along their wall (section 3.3)"),
        number("extension.max_point_to_line_m", "m", 0.001, 1, FIELD(reduction.extension.maxPointToLine),
               "a segment's distance from the horizontal line that is extended"),
        number("extension.min_length_m", "m", 0, 100, FIELD(reduction.extension.minLength),
               "shorter horizontal lines are not extended"),
        count("extension.min_segments", 2, 10000, FIELD(reduction.extension.minSegments),
              "horizontal lines of fewer matched segments are not extended"),
        count("extension.max_column_gap", 1, 10000, FIELD(reduction.extension.maxColumnGap),
              "columns without a fitting segment that an extension crosses"),
        onOff("extension.map_consent", FIELD(reduction.extension.mapConsent),
              "extend only to where a wall of the map stands"),

        onOff("orphan.remove", FIELD(reduction.orphan.remove),
              "also remove single segments that nothing stands beside (section 3.4)"),
        count("orphan.neighbour_columns", 1, 10000, FIELD(reduction.orphan.neighbourColumns),
              "columns to either side in which an orphan has no company"),
        number("orphan.max_distance_m", "m", 0.01, 100, FIELD(reduction.orphan.maxDistance),
               "a kept segment nearer than this is company"),
    };
}

Rows sensorRows() {
    return {
        choice("sensor.pose_reference", {"auto", "turn", "column"}, FIELD(sensor.poseReference),
               "turned 2D scanner: place columns by the turn's one pose or by a pose each"),
        count("sensor.columns_per_turn", 0, 1000000, FIELD(sensor.columnsPerTurn),
              "turned 2D scanner: a turn ends after so many columns; 0: at the azimuth's wrap"),
        number("sensor.max_column_pause_s", "s", 0.001, 3600, FIELD(sensor.maxColumnPause),
               "turned 2D scanner: a longer pause between two columns ends the turn"),
        number("sensor.column_width_deg", "deg", 0, 30, FIELD(sensor.columnWidth),
               "point cloud: azimuth width of a column; 0: found in the cloud"),
        choice("sensor.time_reference", {"first", "middle", "last"}, FIELD(sensor.timeReference),
               "which moment of a scan its time stamp tells"),
        choice("sensor.azimuth", {"auto", "ccw", "cw"}, FIELD(sensor.azimuthSense),
               "rotating scan: the way round in which its azimuth counts"),
        list("sensor.elevations_deg", "deg", -90, 90, {}, FIELD(sensor.elevations),
             "range image: elevations of its rows, row 0 first; empty: known from the model"),
        list("sensor.range_sigma_by_intensity_m", "m", 0, 1, {}, FIELD(sensor.rangeSigmaByIntensity),
             "pairs of an intensity, 0 ... 1, and the sigma of such returns' ranges; empty: alignment.sigma_range_m"),
        number("sensor.min_range_m", "m", 0, 100, FIELD(sensor.minRange),
               "nearer returns are the robot's own, and kept; 0: none"),
        list("sensor.robot_box_m", "m", -100, 100, {0, 6},
             [](const Config& c) { return sidesOf(c.sensor.robotBox); },
             [](Config& c, const std::vector<double>& sides) { c.sensor.robotBox = boxOf(sides); },
             "returns in x_min, x_max, y_min, y_max, z_min, z_max of the vehicle's frame are the robot's own"),
    };
}

Rows poseAndMapRows() {
    return {
        number("pose.max_age_s", "s", 0, 3600, FIELD(pose.maxAge),
               "time from a column to the nearest pose; beyond, the column is kept whole"),
        number("pose.sigma_m", "m", 0, 100, FIELD(pose.sigmaPosition),
               "standard deviation of poses that state none, in x and in y"),
        number("pose.sigma_deg", "deg", 0, 180, FIELD(pose.sigmaYaw),
               "standard deviation of such a pose's heading"),

        number("odometry.position_per_metre_m", "m", 0, 10, FIELD(odometry.positionPerMetre),
               "standard deviation of the position by odometry, in x and in y, after 1 m"),
        number("odometry.heading_per_metre_deg", "deg", 0, 90, FIELD(odometry.headingPerMetre),
               "standard deviation of the heading by odometry after 1 m"),
        number("odometry.heading_per_radian_deg", "deg", 0, 90, FIELD(odometry.headingPerRadian),
               "standard deviation of the heading by odometry after a turn of 1 rad"),

        number("map.sigma_m", "m", 0, 10, FIELD(map.sigma),
               "standard deviation of a wall's position, for walls that state none"),
        number("map.min_length_m", "m", 0, 10, FIELD(map.minLength),
               "of drawings and GIS: lines, with what they join, that are shorter are no walls"),
    };
}
#undef FIELD
// clang-format on

Rows allRows() {
    Rows table;
    for (const auto& section : {segmentRows(), matchingRows(), alignmentRows(),
                                extensionAndOrphanRows(), sensorRows(), poseAndMapRows()}) {
        table.insert(table.end(), section.begin(), section.end());
    }
    return table;
}

/// The key without its section.
std::string_view nameOf(const Parameter& p) { return p.key.substr(p.key.find('.') + 1); }

/// A key with a slip in it, or a key without its section.
size_t mistypedBy(std::string_view text, const Parameter& p) {
    return std::min(editDistance(text, p.key), editDistance(text, nameOf(p)));
}

/// "; did you mean ...?", or where all of them stand.
std::string hint(std::string_view typed, size_t edits, std::string_view nearest) {
    return edits <= typed.size() / 2 ? fmt::format("; did you mean {}?", nearest)
                                     : "; config/default.yaml lists them all";
}

}  // namespace

std::span<const Parameter> parameters() {
    static const Rows table = allRows();
    return table;
}

const Parameter& findParameter(std::string_view key) {
    const auto table = parameters();
    const auto found = std::ranges::find(table, key, &Parameter::key);
    if (found != table.end()) return *found;
    const auto& nearest = *std::ranges::min_element(
        table, {}, [key](const Parameter& p) { return mistypedBy(key, p); });
    throw std::invalid_argument(
        fmt::format("unknown key \"{}\"{}", key, hint(key, mistypedBy(key, nearest), nearest.key)));
}

const Parameter& findSensorParameter(std::string_view name) {
    const Parameter* nearest = nullptr;
    size_t fewest = 0;
    for (const Parameter& p : parameters()) {
        if (!p.key.starts_with("sensor.")) continue;
        const size_t edits = editDistance(name, nameOf(p));
        if (edits == 0) return p;
        if (nearest != nullptr && edits >= fewest) continue;
        nearest = &p;
        fewest = edits;
    }
    throw std::invalid_argument(fmt::format("a single sensor has no key \"{}\"{}", name,
                                            hint(name, fewest, nameOf(*nearest))));
}

}  // namespace offmap::rawlog
