// SPDX-License-Identifier: BSD-3-Clause
#include "MapCheckCommand.h"

#include "../TextSections.h"
#include "GuardedLogs.h"
#include "MapCheckOptions.h"
#include "MapCheckResult.h"
#include "VisitedLog.h"
#include "input/Console.h"
#include "input/GuardedMap.h"
#include "input/LoadedMap.h"
#include "input/UsageError.h"

#include <offmap/rawlog/OutputFile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

namespace offmap::app {

namespace {

/// Places no nearer than a few cm to one another: what stays of them does not grow with the scans.
class SeenPlaces {
 public:
    void add(const mrpt::math::TPoint2D& place) {
        constexpr double cell = 0.04;  // [m]
        const auto number = [](double coordinate) {
            return static_cast<int64_t>(std::floor(coordinate / cell));
        };
        if (places_.size() >= most) return;
        if (cells_.emplace(number(place.x), number(place.y)).second) places_.push_back(place);
    }
    std::vector<mrpt::math::TPoint2D> take() { return std::move(places_); }

 private:
    static constexpr size_t most = 100'000;
    std::set<std::pair<int64_t, int64_t>> cells_;
    std::vector<mrpt::math::TPoint2D> places_;  // [m]
};

/// Reads the logs and compares what they show with the map.
class Checking {
 public:
    Checking(const rawlog::Config& config, const core::LineMap& map,
             const evaluation::PlanCheckConfig& settings)
        : config_(config), map_(map), check_(map, settings) {}

    void addLog(const VisitedLog& log, rawlog::GuardedStatus& status) {
        result_.warnings.insert(result_.warnings.end(), log.warnings.begin(), log.warnings.end());
        visitTurns(log, map_, config_, status,
                   [this](const rawlog::ReducedTurn& turn, const core::ReductionResult& result) {
                       add(turn, result);
                   });
        ++result_.logs;
    }

    /// \throw std::runtime_error if no scan could be used
    MapCheckResult finish() {
        const uint64_t used = result_.scans - result_.notUsed;
        if (used == 0) {
            throw std::runtime_error(fmt::format(
                "of {} none fits the map ({}); check poses and map, offmap info tells of the "
                "poses, --map-origin moves the map",
                counted(result_.scans, "scan"), why_));
        }
        if (result_.notUsed > 0) {
            result_.warnings.push_back(fmt::format("{} of {} left out: {}", result_.notUsed,
                                                   counted(result_.scans, "scan"), why_));
        }
        if (aligned_ > 0) result_.shift = result_.shift * (1.0 / static_cast<double>(aligned_));
        result_.walls = check_.walls();
        result_.seen = places_.take();
        return std::move(result_);
    }

 private:
    void add(const rawlog::ReducedTurn& turn, const core::ReductionResult& result) {
        ++result_.scans;
        const auto segments =
            evaluation::seenSegments(turn.organized.scan, result, config_.reduction);
        if (result.notReduced || segments.empty()) {
            ++result_.notUsed;
            why_ = result.notReduced ? toString(*result.notReduced) : "no vertical segment";
            return;
        }
        if (result.alignment) {
            const auto& mean = result.alignment->correction.mean;
            result_.shift += {mean(0), mean(1)};
            ++aligned_;
        }
        check_.add(segments);
        constexpr double onWall = 0.06, near = 2;  // [m]
        for (const evaluation::SeenSegment& segment : segments) {
            const bool shown = map_.hasWallWithin(segment.place, near) &&
                               !map_.hasWallWithin(segment.place, onWall);
            if (shown) places_.add(segment.place);
        }
    }

    const rawlog::Config& config_;
    const core::LineMap& map_;
    evaluation::PlanCheck check_;
    SeenPlaces places_;
    MapCheckResult result_;
    uint64_t aligned_ = 0;  // scans
    std::string why_;       // the last scan was not used
};

/// The files of a check, which appear together.
class CheckFiles {
 public:
    CheckFiles(const MapCheckOptions& options, rawlog::GuardedStatus& status)
        : options_(options), status_(status) {
        for (const auto* file : {&options.output, &options.profile, &options.picture}) {
            files_.push_back(file->empty()
                                 ? nullptr
                                 : std::make_unique<rawlog::OutputFile>(
                                       *file, rawlog::OutputOptions{{}, options.force, &status}));
        }
    }

    void write(const MapCheckResult& result) {
        files_[0]->write(wallsCsv(result));
        if (files_[1]) files_[1]->write(profileCsv(result));
        if (files_[2]) {
            files_[2]->write(checkPicture(result, options_.picture.extension().string()));
        }
        for (auto& file : files_) {
            if (file) file->finish();
        }
        status_.beginPublishing();
        for (auto& file : files_) {
            if (file) file->publish();
        }
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& file : files_) {
            if (file) names.push_back(file->target().string());
        }
        return names;
    }

 private:
    const MapCheckOptions& options_;
    rawlog::GuardedStatus& status_;
    std::vector<std::unique_ptr<rawlog::OutputFile>> files_;
};

/// What scans are aligned to: a wall may stand as far off as the last check found it, or, before
/// the first, anywhere within the gate. So poses are not bent to suit a wall that is drawn off.
core::LineMap doubted(std::vector<core::Wall> walls, const std::vector<evaluation::WallCheck>& last,
                      double gate) {
    const double widest = gate / 3;  // three sigmas
    for (size_t i = 0; i < walls.size(); ++i) {
        const bool seen = !last.empty() && last[i].seen > 0;
        walls[i].sigma = std::max(walls[i].sigma, seen ? std::min(last[i].rms, widest) : widest);
    }
    return core::LineMap(std::move(walls));
}

MapCheckResult checkRepeatedly(const MapCheckOptions& options, const rawlog::Config& config,
                               const std::vector<core::Wall>& walls, rawlog::GuardedStatus& status,
                               const AtLog& atLog) {
    constexpr int checks = 3;  // a fourth one moves no wall by a millimetre
    std::vector<VisitedLog> logs;
    for (size_t i = 0; i < options.logs.size(); ++i) {
        atLog(i);
        logs.push_back(lookAt(options.logs[i], options.shared.poses, config, status));
    }
    MapCheckResult result;
    for (int check = 0; check < checks; ++check) {
        const core::LineMap map = doubted(walls, result.walls, options.check.gate);
        Checking checking(config, map, options.check);
        for (size_t i = 0; i < logs.size(); ++i) {
            atLog(i);
            checking.addLog(logs[i], status);
        }
        result = checking.finish();
    }
    return result;
}

int check(const MapCheckOptions& options, const rawlog::Config& config, maps::MapOfFile file,
          rawlog::GuardedStatus& status, const AtLog& atLog) {
    CheckFiles files(options, status);
    MapCheckResult result = checkRepeatedly(options, config, file.walls, status, atLog);
    result.mapName = options.shared.map.filename().string();
    result.mapText = describe(file, options.shared.map.string());
    result.file = std::move(file);
    files.write(result);
    say(stdout, "{}", options.json ? checkJson(result) : summaryText(result));
    if (!options.json) say(stdout, "{}", section("wrote", files.names()));
    for (const std::string& warning : result.warnings) say(stderr, "warning: {}\n", warning);
    return exitDone;
}

int checkGuarded(const MapCheckOptions& options) {
    options.requireFiles();
    const rawlog::Config config = options.shared.readConfig();
    const maps::MapOfFile map =
        readMapGuarded(options.shared.map, options.shared.mapFile.request(config));
    for (const std::string& warning : map.warnings) say(stderr, "warning: {}\n", warning);
    return workOnLogs(options.logs, [&](rawlog::GuardedStatus& status, const AtLog& atLog) {
        return check(options, config, map, status, atLog);
    });
}

}  // namespace

void addMapCheckCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command =
        *mapCommand.add_subcommand("check", "Compare a plan with what scans show of the building");
    const auto options = std::make_shared<MapCheckOptions>();
    options->addTo(command);
    command.callback([options, &exitCode] { exitCode = checkGuarded(*options); });
}

}  // namespace offmap::app
