// SPDX-License-Identifier: BSD-3-Clause
#include "SharedOptions.h"

#include "UsageError.h"

#include <offmap/maps/TextMap.h>
#include <offmap/rawlog/ConfigFile.h>

#include <fmt/format.h>
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

rawlog::PoseRequest SharedOptions::poseRequest() const {
    rawlog::PoseRequest request;
    if (!pose.empty()) request.fixed = parsePose(pose, "--pose");
    request.label = poseLabel;
    return request;
}

rawlog::ChosenPoses choosePoses(const SharedOptions& options, const rawlog::Config& config,
                                const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                                bool mayBeMissing) {
    try {
        return rawlog::choosePoses(options.poseRequest(), config, survey, log, mayBeMissing);
    } catch (const rawlog::PoseRequestError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace offmap::app
