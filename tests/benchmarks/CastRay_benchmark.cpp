// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double pitch = 15, house = 10;  // [m] of houses that stand in a square grid

/// A town of square houses, four walls each.
LineMap townOf(int64_t walls) {
    const auto side = static_cast<int>(std::lround(std::sqrt(double(walls) / 4)));
    std::vector<Wall> town;
    for (int i = 0; i < side * side; ++i) {
        const double x = pitch * (i % side), y = pitch * (i / side);
        const TPoint2D a(x, y), b(x + house, y), c(x + house, y + house), d(x, y + house);
        for (const auto& [from, to] :
             {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)}) {
            town.push_back({{from, to}});
        }
    }
    return LineMap(std::move(town));
}

/// Rays in all directions from the crossings of the streets in the middle of the town.
void castRays(benchmark::State& state) {
    const LineMap town = townOf(state.range(0));
    const double middle = pitch * std::floor(std::sqrt(double(town.walls().size()) / 4) / 2);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), offset(-2, 2);
    std::vector<std::pair<TPoint2D, TPoint2D>> rays;
    for (int i = 0; i < 4096; ++i) {
        const double a = angle(random), x = offset(random), y = offset(random);
        rays.push_back({TPoint2D(middle - 2.5 + x, middle - 2.5 + y), {std::cos(a), std::sin(a)}});
    }
    size_t next = 0, hits = 0;
    for (auto _ : state) {
        const auto& [origin, direction] = rays[next++ % rays.size()];
        hits += town.castRay(origin, direction, 100, 0).has_value();
    }
    state.counters["walls"] = double(town.walls().size());
    state.counters["hits"] = benchmark::Counter(double(hits), benchmark::Counter::kAvgIterations);
}
BENCHMARK(castRays)->Arg(100)->Arg(10'000)->Arg(1'000'000);

void buildMap(benchmark::State& state) {
    const auto walls = townOf(state.range(0)).walls();
    for (auto _ : state) benchmark::DoNotOptimize(LineMap(walls));
}
BENCHMARK(buildMap)->Arg(100)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace offmap::core
