// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "PlainText.h"
#include "RenderOptions.h"
#include "SensorLabels.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/NamedFiles.h"
#include "input/UsageError.h"

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/Intensities.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/TurnSearch.h>
#include <offmap/view/Figure.h>
#include <offmap/view/Render.h>

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace offmap::app {

namespace {

/// \throw std::runtime_error if the scan tells none
std::vector<float> requireIntensities(const rawlog::Turn& turn, const rawlog::ScanClass& scanClass,
                                      const core::OrganizedScan& scan) {
    std::vector<float> intensities = rawlog::pointIntensitiesOf(turn, scanClass, scan);
    if (intensities.empty()) {
        throw std::runtime_error(
            fmt::format("the scans of '{}' tell no intensities: choose another --colour-by",
                        printable(turn.front()->sensorLabel)));
    }
    return intensities;
}

void render(const RenderOptions& options, const rawlog::Config& config, const core::LineMap& map,
            view::FigureOptions figure, rawlog::GuardedStatus& status) {
    rawlog::RawlogReader first(options.input), second(options.input);
    const rawlog::LogSurvey survey =
        rawlog::surveyLog(first, config, std::numeric_limits<uint64_t>::max(),
                          [&] { status.atEntry(first.place()); });
    if (survey.damage) throw *survey.damage;
    const auto warnings = checkSingleSensors(config, survey, options.input);
    const rawlog::ChosenPoses poses =
        choosePoses(options.shared, config, options.input, survey, false);
    const auto turn = rawlog::findTurn(second, survey, config, options.entry, options.input,
                                       [&] { status.atEntry(second.place()); });
    if (!turn) {
        throw std::runtime_error(fmt::format("{} has no 3D scan at or after entry {}",
                                             options.input.string(), options.entry));
    }
    rawlog::TurnReducer reducer(map, *poses.source, config, rawlog::OutputClass::Same);
    const mrpt::obs::CObservation& scan = *turn->front();
    const auto* scanClass = rawlog::scanClassOf(scan, config.sensorOf(scan.sensorLabel));
    const rawlog::ReducedTurn reduced = reducer.reduce(*turn, *scanClass);
    const core::OrganizedScan& organized = reduced.organized.scan;
    if (figure.colourBy == view::ColourBy::Intensity) {
        figure.intensities = requireIntensities(*turn, *scanClass, organized);
    }
    view::writePng(view::figureOf(organized, reducer.result(), map, figure), options.output);
    if (!poses.warning.empty()) say(stderr, "warning: {}\n", poses.warning);
    say(stdout, "wrote   {}\n", options.output.string());
    for (const std::string& warning : warnings) say(stderr, "warning: {}\n", warning);
}

int renderGuarded(const RenderOptions& options) {
    using Kind = rawlog::GuardedOutcome::Kind;
    requireDistinct({{"IN", options.input},
                     {"OUT", options.output},
                     {"--map", options.shared.map},
                     {"--config", options.shared.config.file},
                     {"--trajectory", options.shared.poses.trajectory}});
    if (options.output.extension() != ".png") {
        throw UsageError(options.output.string() + ": the picture is a PNG; name it so, .png");
    }
    const view::FigureOptions figure = options.figure();
    const rawlog::Config config = options.shared.readConfig();
    const LoadedMap map = options.shared.readMap(config);
    for (const std::string& warning : map.warnings) say(stderr, "warning: {}\n", warning);
    if (!options.force && std::filesystem::exists(options.output)) {
        throw std::runtime_error(options.output.string() + " exists already; --force replaces it");
    }
    const rawlog::GuardedOutcome outcome =
        reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
            render(options, config, map.lines, figure, status);
            return static_cast<int>(exitDone);
        });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    say(stderr, "offmap: {}\n",
        rawlog::unreadableEntry(options.input, outcome.place.value_or(rawlog::EntryPlace{}),
                                outcome.cause));
    return exitFailed;
}

}  // namespace

void addRenderCommand(CLI::App& app, int& exitCode) {
    CLI::App& command =
        *app.add_subcommand("render", "Draw one scan, what the map knows of it in dark red");
    const auto options = std::make_shared<RenderOptions>();
    options->addTo(command);
    command.callback([options, &exitCode] { exitCode = renderGuarded(*options); });
}

}  // namespace offmap::app
