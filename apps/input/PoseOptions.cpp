// SPDX-License-Identifier: BSD-3-Clause
#include "PoseOptions.h"

#include "NumberList.h"
#include "UsageError.h"

#include <offmap/rawlog/ConfigFile.h>

#include <fmt/format.h>

namespace offmap::app {

void PoseOptions::addTo(CLI::App& command) {
    auto* ofLog = command.add_option("--pose-label", label,
                                     "Which of a log's poses: a label of robot poses or odometry, "
                                     "or 'actions' (in this order if not said)");
    auto* begin = command.add_option("--initial-pose", initial,
                                     "Where the robot began to move, for poses from actions or "
                                     "odometry");
    auto* late = command.add_option("--pose-delay", delay,
                                    "Seconds by which the poses are stamped too late");
    auto* file = command.add_option("--trajectory", trajectory,
                                    "Poses from a text file (TUM, MRPT), instead of the log's own");
    auto* one =
        command.add_option("--pose", fixed, "One pose for the whole log, instead of the log's own");
    auto* sigmas = command.add_option("--pose-sigma", sigma,
                                      "Standard deviations of --pose, --trajectory or "
                                      "--initial-pose (0.05,1)");
    ofLog->type_name("LABEL");
    late->type_name("S");
    file->type_name("FILE")->excludes(ofLog)->excludes(begin);
    one->type_name("X,Y,YAW_DEG")->excludes(ofLog)->excludes(begin)->excludes(late)->excludes(file);
    begin->type_name("X,Y,YAW_DEG");
    sigmas->type_name("M,DEG");
    for (CLI::Option* option : {ofLog, begin, late, file, one, sigmas}) option->check(notEmpty);
}

void PoseOptions::setSigmas(rawlog::Config& config) const {
    if (sigma.empty()) return;
    if (fixed.empty() && trajectory.empty() && initial.empty()) {
        throw UsageError(
            "--pose-sigma tells how certain --pose, --trajectory or --initial-pose is; give one of "
            "them, or leave it out: robot poses state their own");
    }
    const auto sigmas = parseNumbers(sigma, "--pose-sigma", "m,deg");
    rawlog::applySetting(config, fmt::format("pose.sigma_m={}", sigmas[0]));
    rawlog::applySetting(config, fmt::format("pose.sigma_deg={}", sigmas[1]));
}

rawlog::PoseRequest PoseOptions::request() const {
    rawlog::PoseRequest request;
    if (!fixed.empty()) request.fixed = parsePose(fixed, "--pose");
    if (!initial.empty()) request.initial = parsePose(initial, "--initial-pose");
    if (!delay.empty()) request.delay = parseNumbers(delay, "--pose-delay", "s")[0];
    request.trajectory = trajectory;
    request.label = label;
    return request;
}

}  // namespace offmap::app
