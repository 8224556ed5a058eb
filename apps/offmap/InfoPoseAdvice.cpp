// SPDX-License-Identifier: BSD-3-Clause
#include "InfoPoseAdvice.h"

#include "PlainText.h"

#include <fmt/format.h>
#include <mrpt/core/Clock.h>

#include <cmath>

namespace offmap::app {

using core::PoseFault;
using rawlog::PoseOrigin;

namespace {

double seconds(mrpt::Clock::time_point from, mrpt::Clock::time_point to) {
    return mrpt::Clock::toDouble(to) - mrpt::Clock::toDouble(from);
}

/// "poses end 3600.0 s before the first 3D scan"; empty if the times overlap.
std::string gapText(const rawlog::TimeSpan& poses, const rawlog::TimeSpan& scans) {
    if (poses.end < scans.begin) {
        return fmt::format("the poses end {:.1f} s before the first 3D scan",
                           seconds(poses.end, scans.begin));
    }
    if (poses.begin > scans.end) {
        return fmt::format("the poses begin {:.1f} s after the last 3D scan",
                           seconds(scans.end, poses.begin));
    }
    return {};
}

void adviseSource(const PoseFacts& poses, Advice& advice) {
    const PoseSourceFacts* chosen = poses.chosenSource();
    if (!chosen) {
        advice.missing.push_back(
            {"poses, there are none: if the robot stood still, tell where in the map; if it moved, "
             "give a file of poses with --trajectory FILE instead",
             {"--pose", "X,Y,YAW_DEG"}});
        return;
    }
    if (poses.labelMissing) {
        advice.missing.push_back({fmt::format("a choice among the sources of poses; {} covers most "
                                              "3D observations with the least uncertainty",
                                              printable(chosen->label)),
                                  {"--pose-label", chosen->label}});
    }
    if (poses.initialMissing) {
        const bool actions = chosen->origin == PoseOrigin::Actions;
        advice.missing.push_back(
            {fmt::format("the pose in the map where the {} begin{}; or give a file of poses with "
                         "--trajectory FILE instead",
                         actions ? "movements" : "odometry readings", actions ? "" : " to count"),
             {"--initial-pose", "X,Y,YAW_DEG"}});
    }
}

/// \return whether the clocks explain what is not covered
bool adviseClock(const PoseSourceFacts& source, const LogFacts& facts, Advice& advice) {
    const auto& scans = facts.inventory->scanSpan();
    if (!source.times || !scans || source.coverage->covered() > 0) return false;
    const std::string gap = gapText(*source.times, *scans);
    if (gap.empty()) return false;
    advice.missing.push_back(
        {fmt::format("a common clock: {}; if both were recorded together, tell by how much the "
                     "stamps of the poses are late ({:.1f} s, if both began at once)",
                     gap, seconds(scans->begin, source.times->begin)),
         {"--pose-delay", "SECONDS"}});
    return true;
}

void adviseFaults(const PoseSourceFacts& source, const rawlog::Config& config, Advice& advice) {
    for (const auto& [fault, count] : source.coverage->faults()) {
        const double percent = 100.0 * static_cast<double>(count) /
                               static_cast<double>(source.coverage->observations());
        const std::string share =
            fmt::format("{:.1f} % of the 3D observations stay whole", percent);
        if (fault == PoseFault::TooOld || fault == PoseFault::NoPose) {
            advice.hints.push_back(
                {fmt::format("{}, no pose within {:g} s of them; pose.max_age_s sets how old one "
                             "may be, --pose-delay corrects a late clock",
                             share, config.pose.maxAge),
                 {}});
        } else if (fault == PoseFault::TooUncertain) {
            advice.hints.push_back(
                {fmt::format("{}, their poses are too uncertain; "
                             "matching.max_position_radius_m and matching.max_heading_error_deg "
                             "set what is too much",
                             share),
                 {}});
        } else {
            advice.hints.push_back(
                {fmt::format("{}, their poses are not finite or their covariances are none; "
                             "look at what recorded them",
                             share),
                 {}});
        }
    }
}

}  // namespace

void advisePoses(const LogFacts& facts, const rawlog::Config& config, Advice& advice) {
    adviseSource(facts.poses, advice);
    const PoseSourceFacts* chosen = facts.poses.chosenSource();
    if (!chosen || !chosen->coverage || chosen->coverage->observations() == 0) return;
    if (!adviseClock(*chosen, facts, advice)) adviseFaults(*chosen, config, advice);
}

}  // namespace offmap::app
