// SPDX-License-Identifier: BSD-3-Clause
// What the size of the map costs: to load, to cast a ray in, to reduce a scan with.
#include "Office.h"
#include "Town.h"

#include <offmap/core/LineMap.h>
#include <offmap/core/Reducer.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/TextMapWriter.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;
using test::Town;

namespace {

constexpr int64_t smallest = 100, largest = 1'000'000;  // walls

void inDecades(benchmark::internal::Benchmark* benchmark) {
    for (int64_t walls = smallest; walls <= largest; walls *= 10) benchmark->Arg(walls);
}

/// Rays in all directions from the crossings of the streets in the middle of the town.
void castRays(benchmark::State& state) {
    const Town town(state.range(0));
    const LineMap map(town.walls);
    const double crossing = 0.5 * (Town::house + Town::pitch);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), offset(-2, 2);
    std::vector<std::pair<TPoint2D, TPoint2D>> rays;
    for (int i = 0; i < 4096; ++i) {
        const double a = angle(random), x = offset(random), y = offset(random);
        rays.push_back({TPoint2D(crossing + x, crossing + y), {std::cos(a), std::sin(a)}});
    }
    size_t next = 0, hits = 0;
    for (auto _ : state) {
        const auto& [origin, direction] = rays[next++ % rays.size()];
        hits += map.castRay(origin, direction, 100, 0).has_value();
    }
    state.counters["walls"] = double(map.walls().size());
    state.counters["hits"] = benchmark::Counter(double(hits), benchmark::Counter::kAvgIterations);
}
BENCHMARK(castRays)->Apply(inDecades);

/// The same scan of an office that stands by itself in the middle of ever larger towns.
void reduceInTown(benchmark::State& state, MatchingMethod method) {
    const test::Office office(evaluation::paperScanner());
    constexpr int noHouse = 1;  // places around the office
    std::vector<Wall> walls = office.map.walls();
    const Town town(state.range(0), noHouse);
    walls.insert(walls.end(), town.walls.begin(), town.walls.end());
    const LineMap map(std::move(walls));
    ReductionConfig config;
    config.matching.method = method;
    Reducer reducer(map, config);
    for (auto _ : state) benchmark::DoNotOptimize(reducer.reduce(office.scan).labels.data());
    state.counters["walls"] = double(map.walls().size());
}
BENCHMARK_CAPTURE(reduceInTown, paper, MatchingMethod::Paper)
    ->Apply(inDecades)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(reduceInTown, aligned, MatchingMethod::Aligned)
    ->Apply(inDecades)
    ->Unit(benchmark::kMicrosecond);

/// From walls to the index.
void buildMap(benchmark::State& state) {
    const Town town(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(LineMap(town.walls));
}
BENCHMARK(buildMap)->Apply(inDecades)->Unit(benchmark::kMillisecond);

/// From the text to walls.
void parseText(benchmark::State& state) {
    const std::string text = maps::textMapOf(Town(state.range(0)).walls);
    for (auto _ : state) benchmark::DoNotOptimize(maps::parseTextMap(text, "town", 0.03));
    state.SetBytesProcessed(static_cast<int64_t>(text.size()) * state.iterations());
}
BENCHMARK(parseText)->Apply(inDecades)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace offmap::core
