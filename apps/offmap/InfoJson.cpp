// SPDX-License-Identifier: BSD-3-Clause
#include "InfoJson.h"

#include "AdviceText.h"
#include "PlainText.h"
#include "UtcTime.h"

#include <mrpt/core/bits_math.h>
#include <nlohmann/json.hpp>

namespace offmap::app {

using nlohmann::ordered_json;

namespace {

ordered_json orNull(const std::optional<double>& number) {
    return number ? ordered_json(*number) : ordered_json();
}

ordered_json orNull(const std::string& text) {
    return text.empty() ? ordered_json() : ordered_json(text);
}

void addTimes(const std::optional<rawlog::TimeSpan>& times, ordered_json& out) {
    out["first_time_s"] =
        times ? ordered_json(mrpt::Clock::toDouble(times->begin)) : ordered_json();
    out["last_time_s"] = times ? ordered_json(mrpt::Clock::toDouble(times->end)) : ordered_json();
}

ordered_json logJson(const LogFacts& facts) {
    const rawlog::EntryCounts& counts = facts.inventory->entries();
    const auto& span = facts.inventory->span();
    ordered_json out;
    out["file"] = facts.file.string();
    out["bytes"] = facts.fileBytes;
    out["gzip"] = facts.gzip;
    out["unpacked_bytes"] = facts.unpackedBytes;
    out["damage"] = orNull(facts.damage);
    out["entries"] = facts.survey->entries;
    out["observation_entries"] = counts.observations;
    out["action_collections"] = counts.actionCollections;
    out["sensory_frames"] = counts.sensoryFrames;
    out["empty_entries"] = counts.nothing;
    out["observations_without_time"] = counts.withoutTime;
    addTimes(span, out);
    out["first_time_utc"] = span ? ordered_json(utcText(span->begin)) : ordered_json();
    out["last_time_utc"] = span ? ordered_json(utcText(span->end)) : ordered_json();
    return out;
}

ordered_json mountingJson(const mrpt::poses::CPose3D& at) {
    return {{"x_m", at.x()},
            {"y_m", at.y()},
            {"z_m", at.z()},
            {"yaw_deg", mrpt::RAD2DEG(at.yaw())},
            {"pitch_deg", mrpt::RAD2DEG(at.pitch())},
            {"roll_deg", mrpt::RAD2DEG(at.roll())}};
}

ordered_json sensorJson(const rawlog::LogInventory::Sensor& name,
                        const rawlog::SensorInventory& sensor) {
    ordered_json out;
    out["label"] = name.first;
    out["class"] = name.second;
    out["model"] = orNull(sensor.model.name);
    out["details"] = orNull(sensor.model.details);
    out["observations"] = sensor.observations;
    out["rate_hz"] = orNull(sensor.interval.rate());
    addTimes(sensor.span, out);
    out["mounting"] = mountingJson(*sensor.mounting);
    out["mounting_varies"] = sensor.mountingVaries;
    out["scans_3d"] = sensor.scans3d;
    if (!sensor.scans3d) return out;
    out["observations_reducible"] = sensor.reducible;
    out["observations_not_reducible"] = sensor.notReducible;
    out["scans"] = sensor.scans;
    out["points"] = sensor.counts.returns;
    out["points_on_vertical_segments"] = sensor.onVerticalSegments;
    out["points_of_robot"] = sensor.counts.self;
    out["points_not_finite"] = sensor.counts.nonFinite;
    out["external_files"] = sensor.external;
    out["external_files_unreadable"] = sensor.externalMissing;
    out["external_problem"] = orNull(sensor.externalProblem);
    return out;
}

std::string nameOf(rawlog::PoseOrigin origin) {
    using rawlog::PoseOrigin;
    switch (origin) {
        case PoseOrigin::None:
            break;
        case PoseOrigin::Fixed:
            return "fixed";
        case PoseOrigin::Trajectory:
            return "trajectory";
        case PoseOrigin::RobotPoses:
            return "robot_poses";
        case PoseOrigin::Actions:
            return "actions";
        case PoseOrigin::Odometry:
            return "odometry";
    }
    return "none";
}

ordered_json coverageJson(const rawlog::PoseCoverage& coverage) {
    ordered_json out;
    out["observations"] = coverage.observations();
    out["covered"] = coverage.covered();
    out["not_covered"] = ordered_json::object();
    for (const auto& [fault, count] : coverage.faults()) {
        out["not_covered"][std::string(core::toString(fault))] = count;
    }
    return out;
}

ordered_json sourceJson(const PoseSourceFacts& source, bool chosen) {
    ordered_json out;
    out["origin"] = nameOf(source.origin);
    out["label"] = orNull(source.label);
    out["chosen"] = chosen;
    out["count"] = source.count;
    out["count_unusable"] = source.faulty;
    out["rate_hz"] = orNull(source.rate);
    addTimes(source.times, out);
    out["sigma_m"] = orNull(source.sigmaPosition);
    out["sigma_deg"] =
        source.sigmaHeading ? ordered_json(mrpt::RAD2DEG(*source.sigmaHeading)) : ordered_json();
    out["coverage"] = source.coverage ? coverageJson(*source.coverage) : ordered_json();
    return out;
}

ordered_json movementJson(const PoseFacts& poses) {
    const PoseSourceFacts* source = poses.chosenSource();
    if (!source || !source->coverage || !source->coverage->movement().meanSpeed()) return {};
    const rawlog::Movement& movement = source->coverage->movement();
    return {{"distance_m", movement.distance()},
            {"duration_s", movement.seconds()},
            {"mean_speed_m_per_s", *movement.meanSpeed()},
            {"max_speed_m_per_s", movement.maxSpeed()},
            {"max_turn_rate_deg_per_s", mrpt::RAD2DEG(movement.maxTurnRate())}};
}

ordered_json stepsJson(const std::vector<AdviceStep>& steps) {
    ordered_json out = ordered_json::array();
    for (const AdviceStep& step : steps) {
        out.push_back({{"what", step.what}, {"option", orNull(optionText(step))}});
    }
    return out;
}

}  // namespace

std::string infoJson(const LogFacts& facts, const Advice& advice) {
    ordered_json out;
    out["offmap"] = OFFMAP_VERSION;
    out["log"] = logJson(facts);
    out["sensors"] = ordered_json::array();
    for (const auto& [name, sensor] : facts.inventory->sensors()) {
        out["sensors"].push_back(sensorJson(name, sensor));
    }
    out["actions"] = facts.inventory->entries().actions;
    out["poses"] = ordered_json::array();
    for (size_t s = 0; s < facts.poses.sources.size(); ++s) {
        out["poses"].push_back(sourceJson(facts.poses.sources[s], facts.poses.chosen == s));
    }
    out["movement"] = movementJson(facts.poses);
    out["has_scans_to_reduce"] = advice.hasScans;
    out["missing"] = stepsJson(advice.missing);
    out["advice"] = stepsJson(advice.hints);
    out["placeholders"] = advice.placeholders;
    out["command"] = advice.command;
    out["command_line"] = orNull(shellLine(advice.command));
    return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace offmap::app
