// SPDX-License-Identifier: BSD-3-Clause
#include "LiveInput.h"

#include "../Guarded.h"
#include "../NumberList.h"
#include "../UsageError.h"

#include <offmap/live/LogFollower.h>
#include <offmap/live/RawlogReplay.h>
#include <offmap/live/VelodynePcap.h>
#include <offmap/live/VelodyneUdp.h>
#include <offmap/rawlog/FixedPose.h>

#include <fmt/format.h>

#include <limits>

namespace offmap::app {

namespace {

constexpr const char* posesNeeded =
    "has no poses of its own; tell where the robot stands, --pose x,y,yaw_deg, or where it begins "
    "to move, --track x,y,yaw_deg";

void track(const LiveCommandOptions& options, const rawlog::Config& config, LiveInput& input) {
    if (config.reduction.matching.method != core::MatchingMethod::Aligned) {
        throw UsageError("--track needs --method aligned: only it finds the pose of a scan");
    }
    live::MotionNoise noise;
    noise.sigmaPosition = config.pose.sigmaPosition;
    noise.sigmaHeading = config.pose.sigmaYaw;
    input.tracked =
        std::make_shared<live::TrackedPoses>(parsePose(options.track, "--track"), noise);
    input.poses = input.tracked;
    input.posesDescription = fmt::format("tracked from {} on", options.track);
}

/// For a source without poses. \throw UsageError if there are none
void choosePosesWithoutLog(const LiveCommandOptions& options, const rawlog::Config& config,
                           LiveInput& input) {
    if (!options.track.empty()) return track(options, config, input);
    const auto request = options.shared.poses.request();
    if (!request.fixed) throw UsageError(fmt::format("{} {}", options.source, posesNeeded));
    input.poses = std::make_shared<rawlog::FixedPose>(*request.fixed, config.pose.sigmaPosition,
                                                      config.pose.sigmaYaw);
    input.posesDescription = fmt::format("fixed at {}", options.shared.poses.fixed);
}

/// Reads the log once in a child, which survives what a damaged one does to its reader.
void requireReadable(const std::filesystem::path& log, const rawlog::Config& config) {
    const auto outcome = reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
        rawlog::RawlogReader reader(log);
        const auto survey = rawlog::surveyLog(reader, config, std::numeric_limits<uint64_t>::max(),
                                              [&] { status.atEntry(reader.place()); });
        if (survey.damage && survey.entries == 0) throw *survey.damage;
        return static_cast<int>(exitDone);
    });
    if (outcome.kind == rawlog::GuardedOutcome::Kind::Interrupted)
        throw Interrupted(outcome.signal);
    if (outcome.kind == rawlog::GuardedOutcome::Kind::Finished) {
        if (outcome.exitCode != exitDone) throw AlreadyTold(outcome.exitCode);
        return;
    }
    throw std::runtime_error(
        rawlog::unreadableEntry(log, outcome.place.value_or(rawlog::EntryPlace{}), outcome.cause));
}

LiveInput replay(const LiveCommandOptions& options, const rawlog::Config& config) {
    const std::filesystem::path log(options.source);
    requireReadable(log, config);
    rawlog::RawlogReader reader(log);
    LiveInput input;
    const auto survey = std::make_shared<const rawlog::LogSurvey>(
        rawlog::surveyLog(reader, config, std::numeric_limits<uint64_t>::max(), [] {}));
    input.survey = survey;
    if (options.track.empty()) {
        rawlog::ChosenPoses poses = choosePoses(options.shared, config, log, *survey, false);
        input.poses = std::move(poses.source);
        input.posesDescription = poses.description;
        input.warning = poses.warning;
    } else {
        track(options, config, input);
    }
    const double speed = options.speedFactor();
    input.source = std::make_unique<live::RawlogReplay>(log, *survey, config, speed);
    input.description = fmt::format("{}, replayed at {}", log.string(),
                                    options.speed == "max" ? "any speed" : "x" + options.speed);
    return input;
}

LiveInput followed(const LiveCommandOptions& options, const rawlog::Config& config) {
    LiveInput input;
    std::shared_ptr<live::LivePoses> fromLog;
    const auto request = options.shared.poses.request();
    if (options.track.empty() && !request.fixed) {
        fromLog = std::make_shared<live::LivePoses>(config.pose.maxAge);
        input.poses = fromLog;
        input.posesDescription = "robot poses, as the log gets them";
    } else {
        choosePosesWithoutLog(options, config, input);
    }
    if (!std::filesystem::exists(options.source)) {
        throw std::runtime_error(
            fmt::format("cannot open {}: it is not there; start what writes "
                        "it first",
                        options.source));
    }
    input.source = std::make_unique<live::LogFollower>(options.source, config, fromLog,
                                                       live::LogFollower::Options{request.label});
    input.description = options.source + ", while it is written";
    return input;
}

}  // namespace

LiveInput openLiveInput(const LiveCommandOptions& options, const rawlog::Config& config) {
    const auto port = options.udpPort();
    if (!port && !options.isCapture()) {
        return options.follow ? followed(options, config) : replay(options, config);
    }
    LiveInput input;
    choosePosesWithoutLog(options, config, input);
    if (port) {
        input.source = std::make_unique<live::VelodyneUdp>(*port, options.label);
        input.description = fmt::format("Velodyne at UDP port {}", *port);
    } else {
        input.source = std::make_unique<live::VelodynePcap>(options.source, options.label,
                                                            options.speedFactor());
        input.description = options.source + ", a capture of a Velodyne";
    }
    return input;
}

}  // namespace offmap::app
