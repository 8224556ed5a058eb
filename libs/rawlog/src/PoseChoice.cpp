// SPDX-License-Identifier: BSD-3-Clause
#include "LogPoses.h"

#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/PoseChoice.h>
#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/TrajectoryFile.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

namespace offmap::rawlog {
namespace {

using TimePoint = mrpt::Clock::time_point;
using Offers = std::vector<LogPoses>;

/// "2,2.5,17.2"
std::string inDegrees(const mrpt::math::TPose2D& pose) {
    return fmt::format("{:.6g},{:.6g},{:.6g}", pose.x, pose.y, mrpt::RAD2DEG(pose.phi));
}

/// "AMCL, GPS". \param but left out
std::string namesOf(const Offers& offered, const LogPoses* but = nullptr) {
    std::vector<std::string> names;
    for (const LogPoses& offer : offered) {
        if (&offer != but) names.push_back(offer.name.empty() ? "(no label)" : offer.name);
    }
    return names.empty() ? "none at all" : fmt::format("{}", fmt::join(names, ", "));
}

std::string notUsed(const Offers& offered, const LogPoses* used = nullptr) {
    if (offered.size() == (used ? 1 : 0)) return "";
    return fmt::format(" (not used: {})", namesOf(offered, used));
}

void check(const PoseRequest& request) {
    constexpr double longest = 1e10;  // [s] three centuries; as ticks of 100 ns far from overflow
    if (!(std::abs(request.delay) <= longest)) {
        throw PoseRequestError("--pose-delay must be a finite number of seconds");
    }
    const bool ofTheLog = !request.label.empty() || request.initial.has_value();
    if (request.fixed && (!request.trajectory.empty() || ofTheLog || request.delay != 0)) {
        throw PoseRequestError(
            "--pose holds for the whole log: leave out --trajectory, --pose-label, --initial-pose "
            "and --pose-delay");
    }
    if (!request.trajectory.empty() && ofTheLog) {
        throw PoseRequestError(
            "--trajectory takes the place of the log's poses: leave out --pose-label and "
            "--initial-pose");
    }
}

/// None if nothing is offered.
const LogPoses* chosenFrom(const Offers& offered, const PoseRequest& request,
                           const std::filesystem::path& log) {
    if (!request.label.empty()) {
        const auto named = std::ranges::find(offered, request.label, &LogPoses::name);
        if (named != offered.end()) return &*named;
        throw PoseRequestError(fmt::format("{} has no poses labelled '{}'; it has: {}",
                                           log.string(), request.label, namesOf(offered)));
    }
    if (offered.empty()) return nullptr;
    const LogPoses& first = offered.front();
    Offers alike;
    std::ranges::copy_if(offered, std::back_inserter(alike),
                         [&](const LogPoses& offer) { return offer.origin == first.origin; });
    const bool isComplete = request.initial || !first.needsInitialPose();
    if (alike.size() > 1 && isComplete) {
        throw PoseRequestError(fmt::format(
            "{} has {} of several labels; choose one with --pose-label: {}", log.string(),
            first.needsInitialPose() ? "odometry" : "robot poses", namesOf(alike)));
    }
    return &first;
}

void refuseInitialPose(const LogPoses& robotPoses, const Offers& offered,
                       const std::filesystem::path& log) {
    Offers movements;
    std::ranges::copy_if(offered, std::back_inserter(movements), &LogPoses::needsInitialPose);
    throw PoseRequestError(fmt::format(
        "{} has robot poses ({}), which go before what --initial-pose begins: leave it out{}",
        log.string(), robotPoses.name,
        movements.empty()
            ? ""
            : fmt::format(", or choose movements with --pose-label, of: {}", namesOf(movements))));
}

std::string whyNone(const Offers& offered, const std::filesystem::path& log) {
    std::string why = log.string() +
                      " holds no robot pose (CObservationRobotPose), no movement and no odometry; ";
    if (!offered.empty()) {
        std::vector<std::string> movements;
        for (const LogPoses& offer : offered) movements.push_back(offer.describe());
        why = fmt::format(
            "{} holds no robot pose, only {}; --initial-pose x,y,yaw_deg tells where they began, "
            "or ",
            log.string(), fmt::join(movements, ", "));
    }
    return why +
           "give poses with --pose x,y,yaw_deg or --trajectory FILE, or keep every scan whole with "
           "--keep-going";
}

/// The poses as they would be had their stamps not been late. At the ends of time, no overflow.
std::vector<StampedPose> undelayed(std::vector<StampedPose> poses, double delay) {
    using Duration = mrpt::Clock::duration;
    const auto late = std::chrono::round<Duration>(std::chrono::duration<double>(delay));
    for (StampedPose& pose : poses) {
        const Duration::rep ticks = pose.time.time_since_epoch().count();
        Duration::rep early = 0;
        if (!__builtin_sub_overflow(ticks, late.count(), &early)) {
            pose.time = TimePoint(Duration(early));
        }
    }
    return poses;
}

/// Poses of another clock look like poses that are too old; that they all are is worth a word.
std::string whyNoneFits(const std::vector<StampedPose>& poses, const LogSurvey& survey,
                        const Config& config) {
    const auto scans = survey.scanTimes();
    if (!scans || poses.empty()) return "";
    const auto seconds = [](TimePoint time) { return mrpt::Clock::toDouble(time); };
    const auto [first, last] = std::ranges::minmax(poses, {}, &StampedPose::time);
    if (seconds(first.time) <= seconds(scans->end) + config.pose.maxAge &&
        seconds(scans->begin) <= seconds(last.time) + config.pose.maxAge) {
        return "";
    }
    return fmt::format(
        "no pose is of the time of the scans: the poses are of {:.3f} to {:.3f}, the scans of "
        "{:.3f} to {:.3f} seconds since 1970; for a clock that is off there is --pose-delay",
        seconds(first.time), seconds(last.time), seconds(scans->begin), seconds(scans->end));
}

ChosenPoses track(std::vector<StampedPose> poses, PoseOrigin origin, std::string description,
                  const PoseRequest& request, const Config& config, const LogSurvey& survey) {
    if (request.delay != 0) {
        poses = undelayed(std::move(poses), request.delay);
        description += fmt::format(", {:.6g} s late", request.delay);
    }
    std::string warning = whyNoneFits(poses, survey, config);
    return {std::make_unique<PoseTrack>(std::move(poses), config.pose.maxAge),
            std::move(description), origin, std::move(warning)};
}

ChosenPoses fromTrajectory(const PoseRequest& request, const Config& config,
                           const LogSurvey& survey) {
    auto poses =
        readTrajectory(request.trajectory, config.pose.sigmaPosition, config.pose.sigmaYaw);
    const std::string description = fmt::format(
        "trajectory {}: {} pose{}{}", request.trajectory.filename().string(), grouped(poses.size()),
        poses.size() == 1 ? "" : "s", notUsed(posesOffered(survey)));
    return track(std::move(poses), PoseOrigin::Trajectory, description, request, config, survey);
}

}  // namespace

ChosenPoses choosePoses(const PoseRequest& request, const Config& config, const LogSurvey& survey,
                        const std::filesystem::path& log, bool mayBeMissing) {
    check(request);
    const Offers offered = posesOffered(survey);
    if (request.fixed) {
        return {std::make_unique<FixedPose>(*request.fixed, config.pose.sigmaPosition,
                                            config.pose.sigmaYaw),
                "fixed at " + inDegrees(*request.fixed) + notUsed(offered),
                PoseOrigin::Fixed,
                {}};
    }
    if (!request.trajectory.empty()) return fromTrajectory(request, config, survey);

    const LogPoses* const chosen = chosenFrom(offered, request, log);
    if (chosen && request.initial && !chosen->needsInitialPose()) {
        refuseInitialPose(*chosen, offered, log);
    }
    if (!chosen || (chosen->needsInitialPose() && !request.initial)) {
        if (!mayBeMissing) throw std::runtime_error(whyNone(offered, log));
        return {std::make_unique<PoseTrack>(std::vector<StampedPose>{}, config.pose.maxAge),
                "none" + notUsed(offered),
                PoseOrigin::None,
                {}};
    }
    std::string description = chosen->describe();
    if (chosen->needsInitialPose()) {
        description += " from " + inDegrees(*request.initial) + " (--initial-pose)";
    }
    return track(posesOf(*chosen, survey, config, request.initial.value_or(mrpt::math::TPose2D())),
                 chosen->origin, description + notUsed(offered, chosen), request, config, survey);
}

}  // namespace offmap::rawlog
