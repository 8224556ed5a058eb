// SPDX-License-Identifier: BSD-3-Clause
#include "MapFromLogCommand.h"

#include "../TextSections.h"
#include "GuardedLogs.h"
#include "MapConversion.h"
#include "MapFromLogOptions.h"
#include "VisitedLog.h"
#include "input/Console.h"
#include "input/NamedFiles.h"
#include "input/UsageError.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/WallTracer.h>

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

namespace offmap::app {

namespace {

using evaluation::TracedWall;

/// What one reading of all logs shows.
struct Tracing {
    std::vector<TracedWall> walls;
    uint64_t scans = 0;
    uint64_t leftOut = 0;  ///< that fit no place of the map so far
};

std::vector<core::Wall> wallsOf(const std::vector<TracedWall>& traced) {
    std::vector<core::Wall> walls;
    for (const TracedWall& one : traced) walls.push_back(one.wall);
    return walls;
}

/// \param known what the scans are aligned to; empty: their poses are taken as stated
Tracing trace(const MapFromLogOptions& options, const std::vector<VisitedLog>& logs,
              const rawlog::Config& config, const core::LineMap& known, uint32_t minScans,
              rawlog::GuardedStatus& status, const AtLog& atLog) {
    evaluation::WallTracer tracer({.minLength = options.minLength, .minScans = minScans});
    Tracing tracing;
    for (size_t i = 0; i < logs.size(); ++i) {
        atLog(i);
        visitTurns(
            logs[i], known, config, status,
            [&](const rawlog::ReducedTurn& turn, const core::ReductionResult& result) {
                ++tracing.scans;
                if (result.notReduced == core::PoseFault::DoesNotFit) {
                    ++tracing.leftOut;
                    return;
                }
                tracer.add(evaluation::seenSegments(turn.organized.scan, result, config.reduction));
            });
    }
    tracing.walls = tracer.walls();
    return tracing;
}

/// The walls, traced at the stated poses first, then at those that fit what was traced before.
Tracing traceRepeatedly(const MapFromLogOptions& options, const std::vector<VisitedLog>& logs,
                        const rawlog::Config& config, rawlog::GuardedStatus& status,
                        const AtLog& atLog) {
    constexpr int refinements = 2;  // a third one moves no wall by a millimetre
    constexpr uint64_t many = 10;   // scans, of which one alone shows no wall
    Tracing tracing = trace(options, logs, config, core::LineMap({}), options.minScans.value_or(1),
                            status, atLog);
    const uint32_t minScans = options.minScans.value_or(tracing.scans >= many ? 3 : 1);
    for (int i = 0; i < refinements && !tracing.walls.empty(); ++i) {
        const core::LineMap known(wallsOf(tracing.walls));
        tracing = trace(options, logs, config, known, minScans, status, atLog);
    }
    if (!tracing.walls.empty()) return tracing;
    throw std::runtime_error(fmt::format(
        "{} of {} show{} no wall of {} m that {} see{}; --min-length or --min-scans may be "
        "smaller, and offmap info tells whether poses cover the scans",
        counted(tracing.scans, "scan"), counted(logs.size(), "log"), tracing.scans == 1 ? "s" : "",
        options.minLength, counted(minScans, "scan"), minScans == 1 ? "s" : ""));
}

maps::MapOfFile mapOf(const std::vector<core::Wall>& walls) {
    maps::MapOfFile map;
    map.format = "traced";
    map.walls = walls;
    map.layerOf.assign(walls.size(), 0);
    map.layers.push_back({.name = "", .lines = walls.size(), .walls = walls.size()});
    return map;
}

int makeMap(const MapFromLogOptions& options, const rawlog::Config& config,
            rawlog::GuardedStatus& status, const AtLog& atLog) {
    std::vector<VisitedLog> logs;
    for (size_t i = 0; i < options.logs.size(); ++i) {
        atLog(i);
        logs.push_back(lookAt(options.logs[i], options.poses, config, status));
        say(stdout, "{}", section("poses", {logs.back().poses.description}));
    }
    const Tracing tracing = traceRepeatedly(options, logs, config, status, atLog);
    const std::vector<core::Wall> walls = wallsOf(tracing.walls);
    constexpr double gridCell = 0.05;  // [m]
    mapWriterOf(options.output)
        .write({mapOf(walls), options.output, gridCell, {{}, options.force, &status}});
    double length = 0;  // [m]
    for (const core::Wall& wall : walls) length += lengthOf(wall);
    say(stdout, "{}{}",
        section("map", {fmt::format("{}, {:.1f} m, of {}", counted(walls.size(), "wall"), length,
                                    counted(tracing.scans, "scan"))}),
        section("wrote", {options.output.string()}));
    for (const VisitedLog& log : logs) {
        for (const std::string& warning : log.warnings) say(stderr, "warning: {}\n", warning);
    }
    if (tracing.leftOut > 0) {
        say(stderr, "warning: {} left out: what they show does not fit what the others do\n",
            counted(tracing.leftOut, "scan"));
    }
    return exitDone;
}

int makeMapGuarded(const MapFromLogOptions& options) {
    std::vector<NamedFile> read{{"--config", options.config.file},
                                {"--trajectory", options.poses.trajectory}};
    for (const auto& log : options.logs) read.emplace_back("LOG", log);
    std::vector<NamedFile> written{{"OUT", options.output}};
    for (const auto& file : companionsOf(options.output)) written.emplace_back("OUT", file);
    requireDistinct(written, read);
    for (const auto& [name, file] : written) {
        if (options.force || !std::filesystem::exists(file)) continue;
        throw std::runtime_error(file.string() + " exists already; --force replaces it");
    }
    const rawlog::Config config = options.readConfig();
    return workOnLogs(options.logs, [&](rawlog::GuardedStatus& status, const AtLog& atLog) {
        return makeMap(options, config, status, atLog);
    });
}

}  // namespace

void addMapFromLogCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command =
        *mapCommand.add_subcommand("from-log", "Make a first line map of logs with poses");
    const auto options = std::make_shared<MapFromLogOptions>();
    options->addTo(command);
    command.callback([options, &exitCode] { exitCode = makeMapGuarded(*options); });
}

}  // namespace offmap::app
