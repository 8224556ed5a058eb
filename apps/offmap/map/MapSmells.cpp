// SPDX-License-Identifier: BSD-3-Clause
#include "MapSmells.h"

#include "../TextSections.h"

#include <offmap/core/WallGeometry.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace offmap::app {

namespace {

/// "12.3 m", "4,510 km"
std::string lengthText(double metres) {
    return metres < 10'000 ? fmt::format("{:.4g} m", metres)
                           : fmt::format("{:.0f} km", metres / 1000);
}

/// Walls far from most others.
struct Island {
    size_t walls = 0;
    double gap = 0;  ///< [m] between them and the rest, along an axis
};

/// Along one axis: the widest gap between walls, if most of them are on one side of it and hold
/// less ground than the gap itself. \param sides low and high of each wall [m]
std::optional<Island> islandAlong(std::vector<std::pair<double, double>> sides) {
    constexpr double fewest = 0.2, smallestGap = 20;  // share of the walls; [m]
    std::ranges::sort(sides);
    Island island;
    size_t left = 0;
    double reach = sides.front().second, reachAtGap = reach;
    for (size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].first - reach > island.gap) {
            island.gap = sides[i].first - reach;
            left = i;
            reachAtGap = reach;
        }
        reach = std::max(reach, sides[i].second);
    }
    const size_t right = sides.size() - left;
    const bool restIsLeft = left > right;
    island.walls = std::min(left, right);
    const double rest = restIsLeft ? reachAtGap - sides.front().first : reach - sides[left].first;
    const bool isFew =
        static_cast<double>(island.walls) <= fewest * static_cast<double>(sides.size());
    if (!isFew || island.gap < std::max(smallestGap, rest)) return std::nullopt;
    return island;
}

std::optional<Island> islandOf(const std::vector<core::Wall>& walls) {
    std::vector<std::pair<double, double>> alongX, alongY;
    for (const core::Wall& wall : walls) {
        const core::WallBounds bounds = core::boundsOf(wall);
        alongX.emplace_back(bounds.low.x, bounds.high.x);
        alongY.emplace_back(bounds.low.y, bounds.high.y);
    }
    const auto inX = islandAlong(std::move(alongX)), inY = islandAlong(std::move(alongY));
    return inX && (!inY || inX->gap > inY->gap) ? inX : inY;
}

void smellSize(const MapFacts& facts, std::vector<std::string>& smells) {
    constexpr double smallest = 1, largest = 5000;  // [m]
    const auto isTold = [](const std::string& warning) {
        return warning.find("--map-units") != std::string::npos ||
               warning.find("--map-crs") != std::string::npos;
    };
    if (std::ranges::any_of(facts.map.warnings, isTold)) return;
    const double width = facts.high.x - facts.low.x, depth = facts.high.y - facts.low.y;
    const double size = std::max(width, depth);
    if (size >= smallest && size <= largest) return;
    smells.push_back(fmt::format(
        "{} by {} is {}: {}", lengthText(width), lengthText(depth),
        size < smallest ? "less than a room" : "more than a site",
        size < smallest ? "is it drawn to scale? --map-scale 100 makes 1:100 life-size"
                        : "if it looks like millimetres, --map-scale 0.001 makes them metres"));
}

void smellPlace(const MapFacts& facts, std::vector<std::string>& smells) {
    constexpr double farAway = 50'000;  // [m]
    const double x = 0.5 * (facts.low.x + facts.high.x), y = 0.5 * (facts.low.y + facts.high.y);
    const double size = std::max(facts.high.x - facts.low.x, facts.high.y - facts.low.y);
    if (std::hypot(x, y) < std::max(farAway, 2 * size)) return;
    smells.push_back(fmt::format(
        "it stands {} from its origin; unless the poses do, too, --map-origin={:.0f},{:.0f},0 "
        "brings it there",
        lengthText(std::hypot(x, y)), -x, -y));
}

void smellSigma(const MapFacts& facts, std::vector<std::string>& smells) {
    constexpr double largest = 0.5;  // [m]
    if (facts.largestSigma > largest) {
        smells.push_back(
            fmt::format("a sigma of {:.3g} m lets walls explain what stands well before them; 0.01 "
                        "to 0.1 is usual",
                        facts.largestSigma));
    }
    if (facts.leastSigma == 0) {
        smells.emplace_back(
            "a sigma of 0 takes walls for exact; no plan is: state one of a centimetre or more");
    }
}

}  // namespace

std::vector<std::string> smellsOf(const MapFacts& facts) {
    constexpr double shortWall = 0.01;  // [m]
    std::vector<std::string> smells;
    smellSize(facts, smells);
    smellPlace(facts, smells);
    if (const auto island = islandOf(facts.map.walls)) {
        smells.push_back(
            fmt::format("{} {} off the rest by {}: a frame, a legend, or a slip of the pen?",
                        counted(island->walls, "wall"), island->walls == 1 ? "stands" : "stand",
                        lengthText(island->gap)));
    }
    const auto shortOnes = std::ranges::count_if(
        facts.map.walls, [](const auto& wall) { return core::lengthOf(wall) < shortWall; });
    if (shortOnes > 0) {
        smells.push_back(fmt::format("{} shorter than a centimetre, nothing a scanner sees",
                                     counted(static_cast<uint64_t>(shortOnes), "wall")));
    }
    smellSigma(facts, smells);
    return smells;
}

}  // namespace offmap::app
