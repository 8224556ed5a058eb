// SPDX-License-Identifier: BSD-3-Clause
#include "Office.h"

#include <offmap/core/ColumnRing.h>
#include <offmap/core/HorizontalExtension.h>
#include <offmap/core/LevelledScan.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/PointLevel.h>
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/VerticalSegments.h>
#include <offmap/core/WallGate.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace offmap::core {

namespace {

/// A scan on its way through the steps of Reducer::reduce().
struct Steps {
    explicit Steps(const evaluation::Scanner& scanner) : office(scanner) {}

    void levelPoints() { level(office.scan, levelled); }
    void findSegments() { finder.find(office.scan, levelled, segments); }
    void measure() {
        const double maxMountingSlope = std::tan(config.groundInterval.maxMountingTilt);
        measured.clear();
        for (const VerticalSegment& segment : segments) {
            measured.push_back(groundInterval(segment, maxMountingSlope));
        }
    }

    void castRays() {
        viewpoints.assign(office.scan.columns.size(), viewpointOf(office.pose));
        matches.clear();
        for (size_t s = 0; s < segments.size(); ++s) {
            SegmentMatch& match = matches.emplace_back();
            match.measured = measured[s];
            matchByRay(segments[s], *viewpoints[segments[s].column], office.map, config.matching,
                       match);
        }
        byRay = matches;
    }
    void extend() {
        matches = byRay;
        byColumn.build(segments, viewpoints);
        extendAlongWalls(ColumnRing(office.scan), segments, byColumn, viewpoints, office.map,
                         config, extension, matches);
    }

    void sightWalls() {
        places.clear();
        addPlaces(office.scan, places);
        findSights(office.scan, levelled, places, segments, sights);
    }
    void alignPose() {
        const auto& inMap = office.pose.sensorInMap;
        alignment = align(sights, office.map, {inMap.x(), inMap.y()}, office.pose.groundCovariance,
                          config.alignment, aligning);
    }
    void gate() {
        matches.clear();
        const Turn turn(alignment.correction);
        for (const WallSight& sight : sights) {
            matches.push_back(matchByGate(sight, measured[sight.segment], alignment.correction,
                                          turn, office.map, config));
        }
    }
    void judgePoints() {
        const ReturnOffsets offsets(office.scan, levelled, places, alignment.correction, office.map,
                                    config.alignment);
        labels.assign(office.scan.points.size(), PointLabel::NotOnVerticalSegment);
        for (size_t s = 0; s < segments.size(); ++s) {
            std::fill(labels.begin() + segments[s].begin, labels.begin() + segments[s].end,
                      matches[s].mapped() ? PointLabel::Mapped : PointLabel::Kept);
        }
        labelLooseReturns(offsets, segments, matches, looseReturns, labels);
        keepRunsOffTheWall(offsets, segments, matches, labels);
        keepFloorAtTheFoot(offsets, segments, matches, labels);
    }

    const test::Office office;
    ReductionConfig config;
    LevelledScan levelled;
    VerticalSegmentFinder finder{config.vertical};
    std::vector<VerticalSegment> segments;
    std::vector<Interval> measured;
    std::vector<std::optional<Viewpoint>> viewpoints;
    std::vector<SegmentMatch> matches, byRay;
    SegmentsByColumn byColumn;
    ExtensionScratch extension;
    std::vector<ColumnPlace> places;
    std::vector<WallSight> sights;
    AlignmentScratch aligning;
    Alignment alignment;
    LooseReturnsScratch looseReturns;
    std::vector<PointLabel> labels;
};

using Step = void (Steps::*)();
using NamedStep = std::pair<const char*, Step>;

/// Measures the last of the steps; those before it are made once.
void lastStage(benchmark::State& state, const evaluation::Scanner& scanner,
               const std::vector<NamedStep>& steps) {
    Steps scan(scanner);
    for (const auto& [name, step] : steps) (scan.*step)();
    const Step last = steps.back().second;
    for (auto _ : state) (scan.*last)();
    state.counters["points"] = double(scan.office.scan.points.size());
    state.counters["segments"] = double(scan.segments.size());
}

const bool registered = [] {
    const std::vector<NamedStep> common = {{"common/level", &Steps::levelPoints},
                                           {"common/segments", &Steps::findSegments},
                                           {"common/measure", &Steps::measure}};
    const std::vector<NamedStep> paper = {{"paper/rays", &Steps::castRays},
                                          {"paper/extend", &Steps::extend}};
    const std::vector<NamedStep> aligned = {{"aligned/sights", &Steps::sightWalls},
                                            {"aligned/align", &Steps::alignPose},
                                            {"aligned/gate", &Steps::gate},
                                            {"aligned/points", &Steps::judgePoints}};
    for (const auto& [scanner, size] : {std::pair(evaluation::paperScanner(), "181x181"),
                                        std::pair(evaluation::dense(), "128x2048")}) {
        for (const auto* method : {&common, &paper, &aligned}) {
            std::vector<NamedStep> steps;
            if (method != &common) steps = common;
            for (const NamedStep& step : *method) {
                steps.push_back(step);
                benchmark::RegisterBenchmark(
                    (std::string("stage/") + step.first + "/" + size).c_str(), lastStage, scanner,
                    steps)
                    ->Unit(benchmark::kMicrosecond);
            }
        }
    }
    return true;
}();

}  // namespace

}  // namespace offmap::core
