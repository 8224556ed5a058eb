// SPDX-License-Identifier: BSD-3-Clause
#include "LiveInput.h"

#include "NumberList.h"
#include "UsageError.h"

#include <offmap/live/GrabberSource.h>
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

void track(const LiveRequest& request, const rawlog::Config& config, LiveInput& input) {
    if (config.reduction.matching.method != core::MatchingMethod::Aligned) {
        throw UsageError("--track needs --method aligned: only it finds the pose of a scan");
    }
    live::MotionNoise noise;
    noise.sigmaPosition = config.pose.sigmaPosition;
    noise.sigmaHeading = config.pose.sigmaYaw;
    input.tracked =
        std::make_shared<live::TrackedPoses>(parsePose(request.from.track, "--track"), noise);
    input.poses = input.tracked;
    input.posesDescription = fmt::format("tracked from {} on", request.from.track);
}

/// For a source without poses. \throw UsageError if there are none
void choosePosesWithoutLog(const LiveRequest& request, const rawlog::Config& config,
                           LiveInput& input) {
    if (!request.from.track.empty()) return track(request, config, input);
    const auto poses = request.shared.poses.request();
    if (!poses.fixed) throw UsageError(fmt::format("{} {}", request.from.source, posesNeeded));
    input.poses = std::make_shared<rawlog::FixedPose>(*poses.fixed, config.pose.sigmaPosition,
                                                      config.pose.sigmaYaw);
    input.posesDescription = fmt::format("fixed at {}", request.shared.poses.fixed);
}

LiveInput replay(const LiveRequest& request, const rawlog::Config& config) {
    const std::filesystem::path log(request.from.source);
    request.checkLog(log, config);
    rawlog::RawlogReader reader(log);
    LiveInput input;
    input.file = log;
    const auto survey = std::make_shared<const rawlog::LogSurvey>(
        rawlog::surveyLog(reader, config, std::numeric_limits<uint64_t>::max(), request.onEntry));
    input.survey = survey;
    if (request.from.track.empty()) {
        rawlog::ChosenPoses poses =
            choosePoses(request.shared, config, log, *survey, request.forWindow);
        input.poses = std::move(poses.source);
        input.posesDescription = poses.description;
        input.warning = poses.warning;
        if (poses.origin == rawlog::PoseOrigin::None) {
            input.warning = fmt::format("all is kept: {} {}", log.string(), posesNeeded);
        }
    } else {
        track(request, config, input);
    }
    const double speed = request.from.speedFactor();
    const auto atEnd =
        request.forWindow ? live::RawlogReplay::AtEnd::Wait : live::RawlogReplay::AtEnd::Stop;
    auto source = std::make_unique<live::RawlogReplay>(log, *survey, config, speed, atEnd);
    input.replay = source.get();
    input.source = std::move(source);
    input.description =
        fmt::format("{}, replayed at {}", log.string(),
                    request.from.speed == "max" ? "any speed" : "x" + request.from.speed);
    return input;
}

/// For a source that may deliver robot poses. \return where they are to go; null if they are not
/// to be used
std::shared_ptr<live::LivePoses> choosePosesAsTheyCome(const LiveRequest& request,
                                                       const rawlog::Config& config,
                                                       LiveInput& input) {
    if (!request.from.track.empty() || request.shared.poses.request().fixed) {
        choosePosesWithoutLog(request, config, input);
        return nullptr;
    }
    auto poses = std::make_shared<live::LivePoses>(config.pose.maxAge);
    input.poses = poses;
    input.posesDescription = "robot poses, as they come";
    return poses;
}

LiveInput grabbed(const LiveRequest& request, const rawlog::Config& config) {
    LiveInput input;
    input.file = request.from.source;
    const auto poses = choosePosesAsTheyCome(request, config, input);
    live::GrabberSource::Options options;
    options.poseLabel = request.shared.poses.request().label;
    auto source =
        std::make_unique<live::GrabberSource>(request.from.source, config, poses, options);
    const size_t sensors = source->sensors();
    input.description =
        fmt::format("{}, {} sensor{}", request.from.source, sensors, sensors == 1 ? "" : "s");
    input.source = std::move(source);
    return input;
}

LiveInput followed(const LiveRequest& request, const rawlog::Config& config) {
    LiveInput input;
    input.file = request.from.source;
    const auto fromLog = choosePosesAsTheyCome(request, config, input);
    const auto poses = request.shared.poses.request();
    if (!std::filesystem::exists(request.from.source)) {
        throw std::runtime_error(
            fmt::format("cannot open {}: it is not there; start what writes "
                        "it first",
                        request.from.source));
    }
    input.source = std::make_unique<live::LogFollower>(request.from.source, config, fromLog,
                                                       live::LogFollower::Options{poses.label});
    input.description = request.from.source + ", while it is written";
    return input;
}

}  // namespace

LiveInput openLiveInput(const LiveRequest& request, const rawlog::Config& config) {
    const auto port = request.from.udpPort();
    if (request.from.isGrabberFile()) return grabbed(request, config);
    if (!port && !request.from.isCapture()) {
        return request.from.follow ? followed(request, config) : replay(request, config);
    }
    LiveInput input;
    choosePosesWithoutLog(request, config, input);
    if (port) {
        input.source = std::make_unique<live::VelodyneUdp>(*port, request.from.label);
        input.description = fmt::format("Velodyne at UDP port {}", *port);
    } else {
        input.file = request.from.source;
        input.source = std::make_unique<live::VelodynePcap>(request.from.source, request.from.label,
                                                            request.from.speedFactor());
        input.description = request.from.source + ", a capture of a Velodyne";
    }
    return input;
}

}  // namespace offmap::app
