// SPDX-License-Identifier: BSD-3-Clause
// What a scan is reduced by if its map is an occupancy grid, as Markdown: walls along the faces of
// the cells, straight lines, and straight lines in the middle of walls that are a cell thick.
#include <offmap/core/LineMap.h>
#include <offmap/maps/GridLines.h>
#include <offmap/maps/GridWriter.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/WallPlacement.h>
#include <offmap/rawlog/PoseChoice.h>
#include <offmap/rawlog/RegisterClasses.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/TurnSearch.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::grids {

namespace {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose2D;
using Walls = std::vector<core::Wall>;

constexpr double maxRange = 50;  // [m]

/// The first turn of a log and the poses for it.
struct LoggedScan {
    explicit LoggedScan(const std::filesystem::path& log) {
        rawlog::RawlogReader first(log), second(log);
        survey = rawlog::surveyLog(first, config, std::numeric_limits<uint64_t>::max(), [] {});
        turn = rawlog::findTurn(second, survey, config, 0, log, [] {}).value();
        poses = rawlog::choosePoses({}, config, survey, log, false);
    }

    uint64_t removedWith(const core::LineMap& map) const {
        rawlog::TurnReducer reducer(map, *poses.source, config, rawlog::OutputClass::Same);
        const auto sensor = config.sensorOf(turn.front()->sensorLabel);
        return reducer.reduce(turn, *rawlog::scanClassOf(*turn.front(), sensor)).record.removed();
    }

    rawlog::Config config;
    rawlog::LogSurvey survey;
    rawlog::Turn turn;
    rawlog::ChosenPoses poses;
};

/// Of grids that lie differently on the plan: sums, and the least removed count and time of a ray.
struct Figures {
    double grids = 0, walls = 0, removed = 0, least = 1e9, nanoseconds = 1e9;
    double rays = 0, missed = 0, bias = 0, squares = 0;
};

std::vector<TPoint2D> directions() {
    constexpr int count = 3600;
    std::vector<TPoint2D> all;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / count;
        all.emplace_back(std::cos(angle), std::sin(angle));
    }
    return all;
}

void compareRays(const core::LineMap& truth, const core::LineMap& map, Figures& figures) {
    using Clock = std::chrono::steady_clock;
    const auto rays = directions();
    std::vector<std::optional<core::RayHit>> hits;
    const auto begin = Clock::now();
    for (const TPoint2D& ray : rays) hits.push_back(map.castRay({0, 0}, ray, maxRange, 1));
    const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
    figures.nanoseconds =
        std::min(figures.nanoseconds, time.count() / static_cast<double>(rays.size()));
    for (size_t i = 0; i < rays.size(); ++i) {
        const auto expected = truth.castRay({0, 0}, rays[i], maxRange, 1);
        if (!expected) continue;
        // A ray along a face may run past it to the next wall, which is no error of this kind.
        constexpr double otherWall = 0.5;  // [m]
        const double error = hits[i] ? hits[i]->range - expected->range : maxRange;
        ++figures.rays;
        if (std::abs(error) > otherWall) {
            ++figures.missed;
        } else {
            figures.bias += error;
            figures.squares += error * error;
        }
    }
}

Walls wallsOf(const std::vector<mrpt::math::TSegment2D>& lines, const maps::OccupancyGrid& grid,
              const CPose2D& plan, double sigma) {
    Walls walls;
    for (const auto& line : lines) {
        core::Wall wall;
        wall.line = line;
        wall.sigma = std::hypot(sigma, grid.resolution / std::sqrt(12.0));
        walls.push_back(wall);
    }
    walls = maps::placed(std::move(walls), grid.origin, grid.resolution);
    return maps::placed(std::move(walls), CPose2D() - plan, 1);
}

void add(const LoggedScan& scan, const Walls& truth, const Walls& walls, Figures& figures) {
    const core::LineMap map(walls), trueMap(truth);
    const auto removed = static_cast<double>(scan.removedWith(map));
    ++figures.grids;
    figures.walls += static_cast<double>(walls.size());
    figures.removed += removed;
    figures.least = std::min(figures.least, removed);
    compareRays(trueMap, map, figures);
}

void print(double resolution, double yaw, std::string_view name, const Figures& f,
           double reference) {
    const double hits = f.rays - f.missed, bias = f.bias / hits;
    fmt::print(
        "| {:.0f} | {:.0f} | {} | {:.0f} | {:.1f} | {:.1f} | {:+.1f} | {:.1f} | {:.2f} | {:.0f} "
        "|\n",
        100 * resolution, mrpt::RAD2DEG(yaw), name, f.walls / f.grids,
        100 * f.removed / f.grids / reference, 100 * f.least / reference, 1000 * bias,
        1000 * std::sqrt(f.squares / hits - bias * bias), 100 * f.missed / f.rays, f.nanoseconds);
}

void compare(const LoggedScan& scan, const Walls& truth, double resolution, double yaw,
             double reference) {
    Figures faces, oneSided, middle;
    constexpr int phases = 10;
    for (int i = 0; i < phases; ++i) {
        // Steps that fill a cell evenly, by the golden ratio and its square.
        const double x = resolution * std::fmod(i * 0.618, 1),
                     y = resolution * std::fmod(i * 0.382 + 0.1, 1);
        const CPose2D plan(x, y, yaw);
        const maps::OccupancyGrid grid = maps::gridOf(maps::placed(truth, plan, 1), resolution);
        const auto tryWith = [&](const auto& lines, Figures& figures) {
            add(scan, truth, wallsOf(lines, grid, plan, truth.front().sigma), figures);
        };
        tryWith(maps::gridFaceLines(grid), faces);
        tryWith(maps::gridLines(grid, maps::ThinWall::Faces), oneSided);
        tryWith(maps::gridLines(grid, maps::ThinWall::Middle), middle);
    }
    print(resolution, yaw, "faces (`grid`)", faces, reference);
    print(resolution, yaw, "lines at the face", oneSided, reference);
    print(resolution, yaw, "lines, thin ones in the middle (`lines`)", middle, reference);
}

void run(const std::string& plan, const std::string& log) {
    rawlog::registerMrptClasses();
    const LoggedScan scan(log);
    const Walls truth = maps::readTextMap(plan, scan.config.map.sigma);
    const auto reference = static_cast<double>(scan.removedWith(core::LineMap(truth)));
    fmt::print("The lines themselves remove {} points.\n\n", reference);
    fmt::print(
        "| cell [cm] | turned [deg] | walls | number | removed, mean [%] | least [%] "
        "| range bias [mm] | spread [mm] | other wall [%] | ray [ns] |\n"
        "|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const double resolution : {0.02, 0.05, 0.1}) {
        for (const double yawDeg : {0.0, 30.0, 45.0}) {
            compare(scan, truth, resolution, mrpt::DEG2RAD(yawDeg), reference);
        }
    }
}

}  // namespace

}  // namespace offmap::grids

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "offmap_grids PLAN.lines LOG.rawlog\n");
        return 1;
    }
    offmap::grids::run(argv[1], argv[2]);
}
