// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateSummary.h"

#include "../PlainText.h"
#include "../SummaryText.h"
#include "../TextSections.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>

namespace offmap::app {

namespace {

std::string percent(uint64_t part, uint64_t whole) {
    return fmt::format("{:.1f} %",
                       whole ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0);
}

std::string worldText(const SimulationPlan& plan, const SimulateOptions& options) {
    const auto& surfaces = plan.scene.world.surfaces();
    const auto objects =
        std::ranges::count(surfaces, evaluation::SurfaceKind::Object, &evaluation::Surface::kind);
    double metres = 0;
    for (const core::Wall& wall : plan.map) metres += core::lengthOf(wall);
    return fmt::format("{}, seed {}: {} on the map, {:.1f} m; {} that the map does not know",
                       options.world, options.seed, counted(plan.map.size(), "wall"), metres,
                       counted(static_cast<uint64_t>(objects), "object"));
}

std::string robotText(const SimulationPlan& plan, const SimulateOptions& options) {
    std::string text = plan.motion.isNone()
                           ? "stands still while it scans"
                           : fmt::format("moves at {:g} m/s, {:g} deg/s while it scans",
                                         options.speed, options.yawRateDegrees);
    if (options.noCompensation) text += ", unknown to the log";
    return text;
}

std::string poseText(const SimulateOptions& options) {
    std::string text = fmt::format("LOCALIZATION, sigma {} m,deg", options.poseSigma);
    if (options.statedFactor != 1) text += fmt::format(", stated x {:g}", options.statedFactor);
    return text;
}

std::string noiseText(const SimulateOptions& options) {
    std::string text =
        fmt::format("range {:g} m, angle {:g} deg, map {:g} m, tilt {:g} deg", options.rangeNoise,
                    options.angleNoiseDegrees, options.mapError, options.tiltDegrees);
    if (options.mixedPixels) text += ", mixed pixels";
    return text;
}

/// What `offmap reduce` needs to know of the sensor.
std::vector<std::string> configOf(const SimulatedFiles& files, const SimulateOptions& options) {
    if (!files.config.empty()) return {"--config", files.config.string()};
    if (options.scanner == "vlp16" || options.scanClass == "velodyne") return {"--config", "vlp16"};
    return {};
}

}  // namespace

void TruthCounts::add(const LoggedTurn& turn) {
    for (const auto& observation : turn.truth) {
        returns += observation.points.size();
        for (const evaluation::TruePoint& point : observation.points) {
            mapped += point.mapped;
            objects += point.kind == evaluation::SurfaceKind::Object;
            mappedOnSegments += point.mapped && point.onVerticalSegment;
        }
    }
}

std::string summaryOf(const SimulationPlan& plan, const SimulateOptions& options,
                      const TruthCounts& counts) {
    std::string text = section("world", {worldText(plan, options)});
    text += section("scans",
                    {fmt::format("{} of class {}, label {}", rawlog::grouped(plan.places.size()),
                                 options.scanClass, plan.sensor.label)});
    text += section("robot", {robotText(plan, options)});
    text += section("poses", {poseText(options)});
    text += section("noise", {noiseText(options)});
    text += section(
        "returns",
        {fmt::format("{}: {} on the map ({} of these on vertical segments), {} objects",
                     rawlog::grouped(counts.returns), percent(counts.mapped, counts.returns),
                     percent(counts.mappedOnSegments, counts.mapped),
                     percent(counts.objects, counts.returns))});
    return text;
}

std::string nextStepsOf(const SimulatedFiles& files, const SimulateOptions& options) {
    std::vector<std::string> written;
    for (const auto& file : {files.scans, files.map, files.grid, files.truth, files.config}) {
        if (!file.empty()) {
            written.push_back(fmt::format("{} ({})", file.string(), sizeText(sizeOf(file))));
        }
    }
    const std::string reduced = (options.folder / "reduced.rawlog").string();
    std::vector<std::string> reduce{
        "offmap", "reduce", files.scans.string(), "--map", files.map.string(), "-o", reduced};
    std::vector<std::string> score{"offmap", "score", files.truth.string(), reduced};
    const auto config = configOf(files, options);
    reduce.insert(reduce.end(), config.begin(), config.end());
    if (!files.config.empty()) score.insert(score.end(), config.begin(), config.end());
    return section("wrote", written) + "\n" + section("reduce", {shellLine(reduce)}) +
           section("score", {shellLine(score)});
}

}  // namespace offmap::app
