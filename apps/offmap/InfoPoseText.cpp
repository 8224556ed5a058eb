// SPDX-License-Identifier: BSD-3-Clause
#include "InfoPoseText.h"

#include "TextSections.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

namespace offmap::app {

using rawlog::grouped;
using rawlog::PoseOrigin;

namespace {

std::string inWords(PoseOrigin origin) {
    switch (origin) {
        case PoseOrigin::None:
            break;
        case PoseOrigin::Fixed:
            return "fixed pose";
        case PoseOrigin::Trajectory:
            return "poses of a file";
        case PoseOrigin::RobotPoses:
            return "robot pose";
        case PoseOrigin::Actions:
            return "movement";
        case PoseOrigin::Odometry:
            return "odometry reading";
    }
    return "";
}

std::string coverageText(const rawlog::PoseCoverage& coverage) {
    if (coverage.observations() == 0) return "";
    return fmt::format("cover {:.1f} % of the 3D observations", 100 * coverage.share());
}

std::string sourceName(const PoseSourceFacts& source) {
    switch (source.origin) {
        case PoseOrigin::Fixed:
            return "--pose";
        case PoseOrigin::Trajectory:
            return "--trajectory";
        default:
            return nameOf(source.label);
    }
}

Row sourceRow(const PoseSourceFacts& source, bool chosen) {
    const bool given = source.count == 0;  // on the command line
    std::string head =
        given ? inWords(source.origin) : counted(source.count, inWords(source.origin));
    head += rateText(source.rate);
    if (source.sigmaPosition && source.sigmaHeading) {
        head += fmt::format(", sigma {:.2g} m, {:.2g} deg", *source.sigmaPosition,
                            mrpt::RAD2DEG(*source.sigmaHeading));
    }
    if (source.faulty > 0) head += fmt::format(", {} unusable", grouped(source.faulty));
    Row row{sourceName(source), {chosen ? head + "  <- taken" : head}};
    if (source.coverage && source.coverage->observations() > 0) {
        row.second.push_back(coverageText(*source.coverage));
    }
    return row;
}

std::string movementSection(const PoseFacts& poses) {
    const PoseSourceFacts* source = poses.chosenSource();
    if (!source || !source->coverage || source->origin == PoseOrigin::Fixed) return "";
    const rawlog::Movement& movement = source->coverage->movement();
    const auto mean = movement.meanSpeed();
    if (!mean) return "";
    if (movement.distance() == 0) return section("movement", {"none: the robot stands"});
    return section("movement",
                   {fmt::format("{:.1f} m, at {:.2f} m/s on average, {:.2f} m/s and {:.1f} deg/s "
                                "at most",
                                movement.distance(), *mean, movement.maxSpeed(),
                                mrpt::RAD2DEG(movement.maxTurnRate()))});
}

}  // namespace

std::string poseSection(const PoseFacts& poses) {
    std::vector<Row> rows;
    for (size_t s = 0; s < poses.sources.size(); ++s) {
        rows.push_back(sourceRow(poses.sources[s], poses.chosen == s));
    }
    const std::string out = rows.empty() ? section("poses", {"none"}) : table("poses", rows);
    return out + movementSection(poses);
}

}  // namespace offmap::app
