// SPDX-License-Identifier: BSD-3-Clause
#include "Office.h"

#include <offmap/core/Reducer.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
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

/// From the last column to the result: what is left if the others were reduced as they came.
void lastColumn(benchmark::State& state, const evaluation::Scanner& scanner,
                MatchingMethod method) {
    const test::Office office(scanner);
    OrganizedScan allButOne = office.scan;
    allButOne.points.resize(allButOne.columns.back().begin);
    allButOne.sourceIndex.resize(allButOne.columns.back().begin);
    allButOne.columns.pop_back();
    ReductionConfig config;
    config.matching.method = method;
    Reducer reducer(office.map, config);
    for (auto _ : state) {
        reducer.begin();
        reducer.add(allButOne);
        const auto before = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(reducer.finish(office.scan).labels.data());
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
        state.SetIterationTime(took.count());
    }
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
            benchmark::RegisterBenchmark((std::string("lastColumn/") + called + "/" + name).c_str(),
                                         lastColumn, scanner, method)
                ->Unit(benchmark::kMicrosecond)
                ->UseManualTime();
        }
    }
    return true;
}();

}  // namespace

}  // namespace offmap::core
