// SPDX-License-Identifier: BSD-3-Clause
#include "SharedOptions.h"

#include "UsageError.h"

#include <offmap/maps/TextMap.h>
#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/PoseTrack.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/poses/CPose2D.h>

#include <charconv>
#include <cmath>

namespace offmap::app {

namespace {

/// Numbers separated by commas, as many as the form has: "x,y,yaw_deg".
std::vector<double> parseNumbers(const std::string& text, std::string_view option,
                                 std::string_view form) {
    const size_t wanted = 1 + static_cast<size_t>(std::count(form.begin(), form.end(), ','));
    const auto fail = [&] {
        throw UsageError(
            fmt::format("{} is '{}', but must be {} numbers, {}", option, text, wanted, form));
    };
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double number = 0;
        if (at != end && *at == '+') ++at;
        const auto [stop, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) fail();
        numbers.push_back(number);
        if (stop == end) break;
        if (*stop != ',') fail();
        at = stop + 1;
    }
    if (numbers.size() != wanted) fail();
    return numbers;
}

mrpt::math::TPose2D parsePose(const std::string& text, std::string_view option) {
    const auto numbers = parseNumbers(text, option, "x,y,yaw_deg");
    return {numbers[0], numbers[1], mrpt::DEG2RAD(numbers[2])};
}

/// An option whose value was meant to come from a variable that is not set, must not count as not
/// given.
std::string notEmpty(const std::string& value) { return value.empty() ? "is empty" : ""; }

template <class Map>
std::string keysOf(const Map& map) {
    std::vector<std::string> keys;
    for (const auto& entry : map) keys.push_back(entry.first);
    return fmt::format("{}", fmt::join(keys, ", "));
}

}  // namespace

void SharedOptions::addTo(CLI::App& command) {
    command
        .add_option("--map", map, "Wall lines: x1 y1 x2 y2 [sigma [z_min z_max]] per line, metres")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--map-origin", mapOrigin,
                    "Where the map's origin stands in the frame of the poses")
        ->type_name("X,Y,YAW_DEG")
        ->check(notEmpty);
    command.add_option("--method", method, "Matching method: paper (matching.method)")
        ->type_name("METHOD");
    command.add_option("--config", config, "Parameters; what is not set keeps its default")
        ->type_name("FILE.yaml");
    command.add_option("--set", settings, "One parameter, after --config; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    auto* label =
        command.add_option("--pose-label", poseLabel, "Robot poses to use, if a log has several")
            ->type_name("LABEL")
            ->check(notEmpty);
    command.add_option("--pose", pose, "One pose for the whole log, instead of the log's own")
        ->type_name("X,Y,YAW_DEG")
        ->check(notEmpty)
        ->excludes(label);
    command.add_option("--pose-sigma", poseSigma, "Standard deviations of --pose (0.05,1)")
        ->type_name("M,DEG")
        ->check(notEmpty)
        ->needs("--pose");
}

rawlog::Config SharedOptions::readConfig() const {
    rawlog::Config out;
    try {
        if (!config.empty()) rawlog::applyYaml(out, config);
        for (const std::string& setting : settings) rawlog::applySetting(out, setting);
        if (!method.empty()) rawlog::applySetting(out, "matching.method=" + method);
        if (!poseSigma.empty()) {
            const auto sigmas = parseNumbers(poseSigma, "--pose-sigma", "m,deg");
            rawlog::applySetting(out, fmt::format("pose.sigma_m={}", sigmas[0]));
            rawlog::applySetting(out, fmt::format("pose.sigma_deg={}", sigmas[1]));
        }
        out.validate();
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
    return out;
}

core::LineMap SharedOptions::readMap(const rawlog::Config& configuration) const {
    std::vector<core::Wall> walls = maps::readTextMap(map, configuration.map.sigma);
    if (!mapOrigin.empty()) {
        walls = maps::placed(std::move(walls),
                             mrpt::poses::CPose2D(parsePose(mapOrigin, "--map-origin")));
    }
    return core::LineMap(std::move(walls));
}

ChosenPoses choosePoses(const SharedOptions& options, const rawlog::Config& config,
                        const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                        bool mayBeMissing) {
    if (!options.pose.empty()) {
        return {
            std::make_unique<rawlog::FixedPose>(parsePose(options.pose, "--pose"),
                                                config.pose.sigmaPosition, config.pose.sigmaYaw),
            "fixed at " + options.pose};
    }
    auto chosen = survey.poses.begin();
    if (!options.poseLabel.empty()) {
        chosen = survey.poses.find(options.poseLabel);
        if (chosen == survey.poses.end()) {
            throw UsageError(fmt::format(
                "{} has no robot poses labelled '{}'; it has: {}", log.string(), options.poseLabel,
                survey.poses.empty() ? "none at all" : keysOf(survey.poses)));
        }
    } else if (survey.poses.size() > 1) {
        throw UsageError(
            fmt::format("{} has robot poses of several labels; choose one with --pose-label: {}",
                        log.string(), keysOf(survey.poses)));
    }
    if (chosen == survey.poses.end()) {
        if (!mayBeMissing) {
            throw std::runtime_error(
                fmt::format("{} holds no robot pose (CObservationRobotPose); give one with --pose "
                            "x,y,yaw_deg, or keep "
                            "every scan whole with --keep-going",
                            log.string()));
        }
        return {std::make_unique<rawlog::PoseTrack>(std::vector<rawlog::StampedPose>{},
                                                    config.pose.maxAge),
                "none"};
    }
    return {
        std::make_unique<rawlog::PoseTrack>(chosen->second, config.pose.maxAge),
        fmt::format("{}: {} robot pose{}", chosen->first, rawlog::grouped(chosen->second.size()),
                    chosen->second.size() == 1 ? "" : "s")};
}

}  // namespace offmap::app
