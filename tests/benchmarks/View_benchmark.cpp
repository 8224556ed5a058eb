// SPDX-License-Identifier: BSD-3-Clause
#include "Office.h"
#include "Town.h"

#include <offmap/core/Reducer.h>
#include <offmap/view/Colouring.h>
#include <offmap/view/Picking.h>
#include <offmap/view/Scene.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <utility>

namespace offmap::view {

namespace {

/// A reduced scan on its way to the screen.
struct Shown {
    explicit Shown(const evaluation::Scanner& scanner) : office(scanner) {
        core::Reducer reducer(office.map, {});
        result = reducer.reduce(office.scan);
        returns = placedReturns(office.scan, result.labels);
        extent = extentOf(returns);
    }

    const test::Office office;
    core::ReductionResult result;
    PlacedReturns returns;
    mrpt::math::TBoundingBox extent;
};

void place(const Shown& s) {
    benchmark::DoNotOptimize(placedReturns(s.office.scan, s.result.labels).points.data());
}

void bound(const Shown& s) { benchmark::DoNotOptimize(extentOf(s.returns)); }

void colour(const Shown& s, ColourBy colourBy) {
    benchmark::DoNotOptimize(
        coloursOf(s.returns, s.office.scan, s.result, colourBy, Palette{}).data());
}

void buildReturns(const Shown& s) { benchmark::DoNotOptimize(returnsOf(s.returns)); }

void pickAtOnce(const Shown& s) {
    benchmark::DoNotOptimize(pick(s.returns, {{2, 2.5, 1.1}, {1, 0.1, 0}, 0.005}));
}

/// All that a window does for a new scan.
void showFrame(const Shown& s) {
    PlacedReturns returns = placedReturns(s.office.scan, s.result.labels);
    returns.colours = coloursOf(returns, s.office.scan, s.result, ColourBy::Label, Palette{});
    benchmark::DoNotOptimize(returnsOf(returns));
}

void onScan(benchmark::State& state, const evaluation::Scanner& scanner,
            const std::function<void(const Shown&)>& step) {
    const Shown shown(scanner);
    for (auto _ : state) step(shown);
    state.counters["points"] = double(shown.returns.points.size());
}

/// Once for a map, all of which is shown.
void buildWalls(benchmark::State& state) {
    const core::LineMap map(test::Town(state.range(0)).walls);
    const double reach = 1e5;  // [m]
    for (auto _ : state) {
        benchmark::DoNotOptimize(wallsOf(map, {{-reach, -reach, 0}, {reach, reach, 3}}));
    }
    state.counters["walls"] = double(map.walls().size());
}
BENCHMARK(buildWalls)->Arg(1'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);

const bool registered = [] {
    const std::vector<std::pair<const char*, std::function<void(const Shown&)>>> steps = {
        {"placedReturns", place},
        {"extentOf", bound},
        {"coloursOf/label", [](const Shown& s) { colour(s, ColourBy::Label); }},
        {"coloursOf/height", [](const Shown& s) { colour(s, ColourBy::Height); }},
        {"coloursOf/residual", [](const Shown& s) { colour(s, ColourBy::Residual); }},
        {"returnsOf", buildReturns},
        {"pick", pickAtOnce},
        {"frame", showFrame}};
    for (const auto& [scanner, size] : {std::pair(evaluation::paperScanner(), "181x181"),
                                        std::pair(evaluation::dense(), "128x2048")}) {
        for (const auto& [name, step] : steps) {
            benchmark::RegisterBenchmark((std::string("view/") + name + "/" + size).c_str(), onScan,
                                         scanner, step)
                ->Unit(benchmark::kMicrosecond);
        }
    }
    return true;
}();

}  // namespace

}  // namespace offmap::view
