// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ColumnRing.h>
#include <offmap/core/HorizontalExtension.h>
#include <offmap/core/LevelledScan.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/Reducer.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/VerticalSegments.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <vector>

namespace offmap::core {

namespace {

/// The office room with 2 cm of range noise, seen with a pose that is known to 3 cm and 0.5
/// degrees.
struct Office {
    explicit Office(const evaluation::Scanner& scanner) {
        pose.sensorInMap.setFromValues(2, 2.5, 1.1);
        pose.groundCovariance = Eigen::Vector3d(9e-4, 9e-4, 7.6e-5).asDiagonal();
        scan = evaluation::simulate(world, scanner, pose, {.range = 0.02}, 1).scan;
    }
    evaluation::World world = evaluation::officeRoom();
    LineMap map{mapOf(world)};
    SensorPose pose;
    OrganizedScan scan;
};

/// 16 rings and 3600 columns: a VLP-16 at 5 turns a second.
evaluation::Scanner slowVlp16() {
    auto scanner = evaluation::vlp16();
    scanner.azimuths.clear();
    for (int c = 0; c < 3600; ++c) scanner.azimuths.push_back(-2 * std::numbers::pi * c / 3600);
    return scanner;
}

/// A scan on its way through the steps of Reducer::reduce().
struct Steps {
    explicit Steps(const Office& scanned) : office(scanned) {}

    void levelPoints() { level(office.scan, levelled); }
    void findSegments() {
        findVerticalSegments(office.scan, levelled, config.vertical, splitting, segments);
    }
    void match() {
        viewpoints.assign(office.scan.columns.size(), viewpointOf(office.pose));
        matches.clear();
        for (const VerticalSegment& segment : segments) {
            matches.push_back(matchByRay(segment,
                                         groundInterval(segment, levelled, config.groundInterval),
                                         *viewpoints[segment.column], office.map, config.matching));
        }
    }
    void extend() {
        byColumn.build(segments, viewpoints);
        extendAlongWalls(ColumnRing(office.scan), segments, byColumn, viewpoints, office.map,
                         config, extension, matches);
    }

    const Office& office;
    ReductionConfig config;
    LevelledScan levelled;
    SplitAndMergeScratch splitting;
    std::vector<VerticalSegment> segments;
    std::vector<std::optional<Viewpoint>> viewpoints;
    std::vector<SegmentMatch> matches;
    SegmentsByColumn byColumn;
    ExtensionScratch extension;
};

void levelStage(benchmark::State& state) {
    const Office office(evaluation::paperScanner());
    Steps steps(office);
    for (auto _ : state) steps.levelPoints();
}
BENCHMARK(levelStage)->Unit(benchmark::kMicrosecond);

void findSegmentsStage(benchmark::State& state) {
    const Office office(evaluation::paperScanner());
    Steps steps(office);
    steps.levelPoints();
    for (auto _ : state) steps.findSegments();
    state.counters["segments"] = double(steps.segments.size());
}
BENCHMARK(findSegmentsStage)->Unit(benchmark::kMicrosecond);

void matchStage(benchmark::State& state) {
    const Office office(evaluation::paperScanner());
    Steps steps(office);
    steps.levelPoints();
    steps.findSegments();
    for (auto _ : state) steps.match();
}
BENCHMARK(matchStage)->Unit(benchmark::kMicrosecond);

void extendStage(benchmark::State& state) {
    const Office office(evaluation::paperScanner());
    Steps steps(office);
    steps.levelPoints();
    steps.findSegments();
    steps.match();
    const auto matches = steps.matches;
    for (auto _ : state) {
        steps.matches = matches;
        steps.extend();
    }
}
BENCHMARK(extendStage)->Unit(benchmark::kMicrosecond);

void reduceWhole(benchmark::State& state, const evaluation::Scanner& scanner) {
    const Office office(scanner);
    Reducer reducer(office.map, {});
    for (auto _ : state) benchmark::DoNotOptimize(reducer.reduce(office.scan).labels.data());
    const auto& labels = reducer.reduce(office.scan).labels;
    state.counters["points"] = double(office.scan.points.size());
    state.counters["mapped"] = double(std::count(labels.begin(), labels.end(), PointLabel::Mapped));
}
BENCHMARK_CAPTURE(reduceWhole, paper, evaluation::paperScanner())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(reduceWhole, vlp16, slowVlp16())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(reduceWhole, dense, evaluation::dense())->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace offmap::core
