// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>
#include <offmap/evaluation/SeenSegments.h>
#include <offmap/evaluation/SurfaceLines.h>
#include <offmap/evaluation/WeightedLine.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::evaluation {

struct WallTracerConfig {
    double minLength = 0.5;      ///< [m] of a wall
    uint32_t minScans = 1;       ///< that show it
    double maxGap = 0.5;         ///< [m] in a wall; wider ones part it
    double maxCornerGap = 0.3;   ///< [m] that walls are made longer or shorter by to meet
    double sigmaSegment = 0.02;  ///< [m] standard deviation of a segment's place, the pose apart
    SurfaceLineConfig line{};
};

/// A wall as scans show it.
struct TracedWall {
    core::Wall wall;    ///< sigma: how its segments scatter about it
    uint32_t scans;     ///< that show it
    uint64_t segments;  ///< on it
};

/// Draws the walls that scans show: the lines of each scan, merged over the scans where they lie on
/// one another. Memory grows with the walls, not with the scans.
class WallTracer {
 public:
    explicit WallTracer(const WallTracerConfig& config) : config_(config) {}

    /// One scan's segments, by column. What is seen over is no wall.
    void add(std::span<const SeenSegment> segments);

    /// Those long and often seen enough; ends that nearly meet do.
    std::vector<TracedWall> walls() const;

 private:
    struct Trace {
        WeightedLine fit;
        double from, to;            // [m] along fit.line()
        mrpt::math::TPoint2D away;  // unit normal, away from the sensor
        double sigma;               // [m] that the poses leave it to be displaced by
        uint32_t scans, lastScan;
        uint64_t segments;

        mrpt::math::TPoint2D begin() const { return fit.line().at(from); }
        mrpt::math::TPoint2D end() const { return fit.line().at(to); }
    };

    Trace traceOf(const SurfaceLine& line, std::span<const SeenSegment> segments) const;
    bool belongTogether(const Trace& a, const Trace& b) const;
    void insert(Trace trace);

    WallTracerConfig config_;
    std::vector<Trace> traces_;
    uint32_t scan_ = 0;
};

/// Moves ends that are at most maxGap [m] from where their line meets another wall, which stands or
/// ends there, to that place.
void closeCorners(std::vector<core::Wall>& walls, double maxGap);

}  // namespace offmap::evaluation
