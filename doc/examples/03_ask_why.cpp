// SPDX-License-Identifier: BSD-3-Clause
// A scanner of your own, column by column, and why each vertical segment was removed or kept. Needs
// offmap::core only.
#include <offmap/core/Reducer.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace offmap::core;

namespace {

constexpr double sensorHeight = 1.0;  // [m]
const auto start = mrpt::Clock::fromDouble(1e9);

/// What truly stands there: a corridor along x, 3 m wide; a crate on the left that the map does not
/// show, and on the right a door that is open: behind it, 1 m further, the wall of another room.
std::vector<Wall> truth() {
    return {{.line = {{-20, 1.5}, {20, 1.5}}},
            {.line = {{2.0, 1.0}, {3.5, 1.0}}, .height = {0.0, 0.8}},
            {.line = {{-20, -1.5}, {2.0, -1.5}}},
            {.line = {{3.5, -1.5}, {20, -1.5}}},
            {.line = {{0.0, -2.5}, {8.0, -2.5}}}};
}

/// What the map says: a plain corridor, its walls good to 2 cm, and 1 cm off.
std::vector<Wall> plan() {
    return {{.line = {{-20, 1.49}, {20, 1.49}}, .sigma = 0.02},
            {.line = {{-20, -1.51}, {20, -1.51}}, .sigma = 0.02}};
}

/// One column, taken at one time from one place. Its points are in the frame that the sensor had
/// then, from bottom to top as seen from the sensor, and no more than one per beam.
void appendColumn(OrganizedScan& scan, const LineMap& world, double azimuth,
                  std::chrono::milliseconds age) {
    // The vehicle drives along x at 1 m/s; the pose says so with sigmas of 2 cm and 0.3 degrees.
    const double x = std::chrono::duration<double>(age).count();
    const Eigen::Vector3d sigmas(0.02, 0.02, 0.3 * M_PI / 180.0);
    ScanColumn column;
    column.begin = static_cast<uint32_t>(scan.points.size());
    column.azimuth = static_cast<float>(azimuth);
    column.time = start + age;
    column.sensor = SensorPose{mrpt::poses::CPose3D(x, 0, sensorHeight, 0, 0, 0),
                               sigmas.cwiseAbs2().asDiagonal()};
    double lastSlope = -1e9;
    for (double z = 0.1; z < 2.4; z += 0.1) {
        const auto hit = world.castRay({x, 0}, {std::cos(azimuth), std::sin(azimuth)}, 30.0, z);
        if (!hit) continue;
        const double height = z - sensorHeight, slope = height / hit->range;
        if (slope <= lastSlope) continue;  // hidden by what stands before it
        lastSlope = slope;
        scan.points.emplace_back(static_cast<float>(hit->range * std::cos(azimuth)),
                                 static_cast<float>(hit->range * std::sin(azimuth)),
                                 static_cast<float>(height));
        scan.sourceIndex.push_back(static_cast<uint32_t>(scan.sourceIndex.size()));
    }
    column.end = static_cast<uint32_t>(scan.points.size());
    scan.columns.push_back(column);
}

std::string text(const std::optional<Interval>& interval) {
    char text[40] = "-";
    if (interval) {
        std::snprintf(text, sizeof text, "%.2f .. %.2f", interval->min(), interval->max());
    }
    return text;
}

std::string outcome(const SegmentMatch& match) {
    std::string text(toString(match.verdict));
    if (match.verdict == Verdict::Kept) text.append(": ").append(toString(match.reason));
    return text;
}

}  // namespace

int main() {
    // A turn of 0.1 s: counter-clockwise, in steps of 10 degrees.
    const LineMap world(truth()), map(plan());
    OrganizedScan scan;
    for (int c = 0; c < 36; ++c) {
        appendColumn(scan, world, (10.0 * c - 175.0) * M_PI / 180.0,
                     std::chrono::milliseconds(3 * c));
    }

    Reducer reducer(map, ReductionConfig());
    const ReductionResult& result = reducer.reduce(scan);
    std::printf("azimuth  height [m]    measured [m]  predicted [m] sigmas  wall verdict\n");
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const VerticalSegment& segment = result.segments[s];
        const SegmentMatch& match = result.matches[s];
        const double azimuth = scan.columns[segment.column].azimuth * 180 / M_PI;
        if (std::abs(azimuth) > 70) continue;  // what stands in front
        std::printf("%+7.0f %5.1f .. %4.1f %15s %14s %+6.1f %5s %s\n", azimuth,
                    segment.bottom.y + sensorHeight, segment.top.y + sensorHeight,
                    text(match.measured).c_str(), text(match.predicted).c_str(), match.residual,
                    match.wall ? std::to_string(*match.wall).c_str() : "-", outcome(match).c_str());
    }
}
