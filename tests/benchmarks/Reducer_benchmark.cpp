// SPDX-License-Identifier: BSD-3-Clause
#include "Office.h"

#include <offmap/core/Reducer.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

namespace offmap::core {

namespace {

/// 16 rings and 3600 columns: a VLP-16 at 5 turns a second.
evaluation::Scanner slowVlp16() {
    auto scanner = evaluation::vlp16();
    scanner.azimuths.clear();
    for (int c = 0; c < 3600; ++c) scanner.azimuths.push_back(-2 * std::numbers::pi * c / 3600);
    return scanner;
}

void reduceWhole(benchmark::State& state, const evaluation::Scanner& scanner,
                 MatchingMethod method) {
    const test::Office office(scanner);
    ReductionConfig config;
    config.matching.method = method;
    Reducer reducer(office.map, config);
    for (auto _ : state) benchmark::DoNotOptimize(reducer.reduce(office.scan).labels.data());
    const auto& labels = reducer.reduce(office.scan).labels;
    state.counters["points"] = double(office.scan.points.size());
    state.counters["mapped"] = double(std::count(labels.begin(), labels.end(), PointLabel::Mapped));
}

const bool registered = [] {
    for (const auto& [scanner, name] :
         {std::pair(evaluation::paperScanner(), "181x181"), std::pair(slowVlp16(), "16x3600"),
          std::pair(evaluation::dense(), "128x2048")}) {
        for (const auto& [method, called] :
             {std::pair(MatchingMethod::Paper, "paper"),
              std::pair(MatchingMethod::Probabilistic, "probabilistic"),
              std::pair(MatchingMethod::Aligned, "aligned")}) {
            benchmark::RegisterBenchmark(
                (std::string("reduceWhole/") + called + "/" + name).c_str(), reduceWhole, scanner,
                method)
                ->Unit(benchmark::kMicrosecond);
        }
    }
    return true;
}();

}  // namespace

}  // namespace offmap::core
