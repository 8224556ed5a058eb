// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/PoseChoice.h>
#include <offmap/rawlog/PoseTrack.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

namespace offmap::rawlog {
namespace {

template <class Map>
std::string keysOf(const Map& map) {
    std::vector<std::string> keys;
    for (const auto& entry : map) keys.push_back(entry.first);
    return fmt::format("{}", fmt::join(keys, ", "));
}

/// "2,2.5,17.2"
std::string inDegrees(const mrpt::math::TPose2D& pose) {
    return fmt::format("{:.6g},{:.6g},{:.6g}", pose.x, pose.y, mrpt::RAD2DEG(pose.phi));
}

ChosenPoses track(std::vector<StampedPose> poses, const Config& config, PoseOrigin origin,
                  std::string description) {
    return {std::make_unique<PoseTrack>(std::move(poses), config.pose.maxAge),
            std::move(description),
            origin,
            {}};
}

}  // namespace

ChosenPoses choosePoses(const PoseRequest& request, const Config& config, const LogSurvey& survey,
                        const std::filesystem::path& log, bool mayBeMissing) {
    if (request.fixed) {
        return {std::make_unique<FixedPose>(*request.fixed, config.pose.sigmaPosition,
                                            config.pose.sigmaYaw),
                "fixed at " + inDegrees(*request.fixed),
                PoseOrigin::Fixed,
                {}};
    }
    auto chosen = survey.poses.begin();
    if (!request.label.empty()) {
        chosen = survey.poses.find(request.label);
        if (chosen == survey.poses.end()) {
            throw PoseRequestError(fmt::format(
                "{} has no robot poses labelled '{}'; it has: {}", log.string(), request.label,
                survey.poses.empty() ? "none at all" : keysOf(survey.poses)));
        }
    } else if (survey.poses.size() > 1) {
        throw PoseRequestError(
            fmt::format("{} has robot poses of several labels; choose one with --pose-label: {}",
                        log.string(), keysOf(survey.poses)));
    }
    if (chosen == survey.poses.end()) {
        if (mayBeMissing) return track({}, config, PoseOrigin::None, "none");
        throw std::runtime_error(
            fmt::format("{} holds no robot pose (CObservationRobotPose); give one with --pose "
                        "x,y,yaw_deg, or keep every scan whole with --keep-going",
                        log.string()));
    }
    return track(chosen->second, config, PoseOrigin::RobotPoses,
                 fmt::format("{}: {} robot pose{}", chosen->first, grouped(chosen->second.size()),
                             chosen->second.size() == 1 ? "" : "s"));
}

}  // namespace offmap::rawlog
