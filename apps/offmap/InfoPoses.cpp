// SPDX-License-Identifier: BSD-3-Clause
#include "InfoPoses.h"

#include "input/UsageError.h"

#include <offmap/rawlog/IntervalMedian.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace offmap::app {

using rawlog::PoseOrigin;

namespace {

std::optional<double> medianOf(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

template <class Stamped>
void addTimes(const std::vector<Stamped>& all, PoseSourceFacts& out) {
    out.count = all.size();
    rawlog::IntervalMedian interval;
    for (const Stamped& one : all) {
        interval.add(one.time);
        out.times = rawlog::spanned(out.times, one.time);
    }
    out.rate = interval.rate();
}

PoseSourceFacts robotPoses(const std::string& label, const std::vector<rawlog::StampedPose>& all) {
    PoseSourceFacts out;
    out.origin = PoseOrigin::RobotPoses;
    out.label = label;
    addTimes(all, out);
    std::vector<double> position, heading;  // [m], [rad]
    for (const rawlog::StampedPose& pose : all) {
        if (pose.fault) {
            ++out.faulty;
            continue;
        }
        const auto& covariance = pose.groundCovariance;
        position.push_back(std::sqrt(std::max({0.0, covariance[0], covariance[3]})));
        heading.push_back(std::sqrt(std::max(0.0, covariance[5])));
    }
    out.sigmaPosition = medianOf(std::move(position));
    out.sigmaHeading = medianOf(std::move(heading));
    return out;
}

PoseSourceFacts movementsOf(const rawlog::ActionSurvey& actions) {
    PoseSourceFacts out;
    out.origin = PoseOrigin::Actions;
    out.label = "actions";  // by this name --pose-label knows them
    out.count = actions.movements;
    rawlog::IntervalMedian interval;
    for (const rawlog::MotionStep& step : actions.steps) {
        out.faulty += step.fault.has_value();
        if (!step.time) continue;
        interval.add(*step.time);
        out.times = rawlog::spanned(out.times, *step.time);
    }
    out.rate = interval.rate();
    return out;
}

std::vector<PoseSourceFacts> sourcesOf(const rawlog::LogSurvey& survey) {
    std::vector<PoseSourceFacts> sources;
    for (const auto& [label, poses] : survey.poses) sources.push_back(robotPoses(label, poses));
    if (auto actions = movementsOf(survey.actions); actions.times) {
        sources.push_back(std::move(actions));
    }
    for (const auto& [label, readings] : survey.odometry) {
        PoseSourceFacts& odometry = sources.emplace_back();
        odometry.origin = PoseOrigin::Odometry;
        odometry.label = label;
        addTimes(readings, odometry);
    }
    return sources;
}

bool needsInitialPose(const PoseSourceFacts& source) {
    return source.origin == PoseOrigin::Actions || source.origin == PoseOrigin::Odometry;
}

/// The poses that a source would give, were it chosen; movements begin anywhere if it is not known
/// where.
void addPoses(PoseSourceFacts& source, const rawlog::PoseRequest& wanted,
              const rawlog::Config& config, const std::filesystem::path& log,
              const rawlog::LogSurvey& survey) {
    rawlog::PoseRequest request;
    request.label = source.label;
    request.delay = wanted.delay;
    if (needsInitialPose(source)) {
        request.initial = wanted.initial.value_or(mrpt::math::TPose2D());
    }
    try {
        source.poses = rawlog::choosePoses(request, config, survey, log, true).source;
    } catch (const rawlog::PoseRequestError&) {
        source.poses = nullptr;  // one without a label among several: it cannot be asked for
    }
}

/// Remembers which source reduction would take, and what it lacks to do so.
void choose(const rawlog::PoseRequest& request, PoseFacts& facts) {
    const auto& sources = facts.sources;
    if (sources.empty()) return;
    facts.chosen = 0;
    if (request.label.empty()) {
        const auto alike = std::ranges::count(sources, sources[0].origin, &PoseSourceFacts::origin);
        facts.labelMissing = alike > 1;
    } else {
        const auto named = std::ranges::find(sources, request.label, &PoseSourceFacts::label);
        facts.chosen = static_cast<size_t>(named - sources.begin());
    }
    facts.initialMissing = needsInitialPose(sources[*facts.chosen]) && !request.initial;
}

}  // namespace

void PoseFacts::chooseBest() {
    if (!labelMissing) return;
    const auto merit = [](const PoseSourceFacts& source) {
        const uint64_t covered = source.coverage ? source.coverage->covered() : 0;
        return std::tuple(covered, -source.sigmaPosition.value_or(1e9), source.count);
    };
    const PoseOrigin origin = sources[*chosen].origin;
    for (size_t s = 0; s < sources.size(); ++s) {
        if (sources[s].origin == origin && merit(sources[s]) > merit(sources[*chosen])) chosen = s;
    }
}

PoseFacts findPoses(const SharedOptions& options, const rawlog::Config& config,
                    const std::filesystem::path& log, const rawlog::LogSurvey& survey) {
    PoseFacts facts;
    facts.sources = sourcesOf(survey);
    const rawlog::PoseRequest request = options.poses.request();
    for (PoseSourceFacts& source : facts.sources) addPoses(source, request, config, log, survey);
    choose(request, facts);
    const bool given = request.fixed || !request.trajectory.empty();
    if (given || !facts.labelMissing) {
        rawlog::ChosenPoses taken = choosePoses(options, config, log, survey, true);
        if (given) {
            facts.sources.insert(facts.sources.begin(), PoseSourceFacts());
            facts.sources[0].origin = taken.origin;
            facts.sources[0].poses = std::move(taken.source);
            facts.chosen = 0;
            facts.labelMissing = facts.initialMissing = false;
        }
    }
    for (PoseSourceFacts& source : facts.sources) {
        if (!source.poses) continue;
        using Errors = rawlog::PoseCoverage::Errors;
        const Errors errors = needsInitialPose(source) ? Errors::Common : Errors::Independent;
        source.coverage = std::make_unique<rawlog::PoseCoverage>(*source.poses,
                                                                 config.reduction.matching, errors);
    }
    return facts;
}

}  // namespace offmap::app
