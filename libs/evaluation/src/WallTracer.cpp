// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/WallTracer.h>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

using core::FittedLine;
using mrpt::math::TPoint2D;

namespace {

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

/// [m] Standard deviation of a place along a unit vector.
double sigmaAlong(const SeenSegment& segment, const TPoint2D& direction) {
    const Eigen::Vector2d u(direction.x, direction.y);
    return std::sqrt(std::max(0.0, u.dot(segment.covariance * u)));
}

TPoint2D normalOf(const FittedLine& line) { return {-line.direction.y, line.direction.x}; }

/// [m] Standard deviation of the weighted mean of two estimates of one place.
double merged(double a, double b) {
    const double both = std::hypot(a, b);
    return both > 0 ? a * b / both : 0;
}

/// The reach of points along a line.
struct Reach {
    double from, to;  // [m]

    void add(double coordinate) {
        from = std::min(from, coordinate);
        to = std::max(to, coordinate);
    }
};

}  // namespace

WallTracer::Trace WallTracer::traceOf(const SurfaceLine& line,
                                      std::span<const SeenSegment> segments) const {
    Trace trace{};
    const TPoint2D across(-line.direction.y, line.direction.x);
    for (const uint32_t s : line.segments) {
        const double byPose = sigmaAlong(segments[s], across);
        const double sigma = std::hypot(byPose, config_.sigmaSegment);
        trace.fit.add(segments[s].place, 1 / (sigma * sigma));
        trace.sigma = std::max(trace.sigma, byPose);
    }
    const FittedLine fitted = trace.fit.line();
    Reach reach{0, 0};  // the line's point is the places' mean, so 0 lies between
    for (const uint32_t s : line.segments) reach.add(fitted.along(segments[s].place));
    trace.from = reach.from;
    trace.to = reach.to;
    const SeenSegment& middle = segments[line.segments[line.segments.size() / 2]];
    trace.away = normalOf(fitted);
    if (dot(trace.away, middle.place - middle.sensor) < 0) trace.away = trace.away * -1;
    trace.scans = 1;
    trace.lastScan = scan_;
    trace.segments = line.segments.size();
    return trace;
}

/// Whether both are the same face of one wall, as far as the poses let tell.
bool WallTracer::belongTogether(const Trace& a, const Trace& b) const {
    constexpr double exact = 0.03;    // [m] however well the poses are known
    constexpr double sameFace = 0.9;  // cosine of 25 degrees
    constexpr double widest = 0.3;    // [m] further apart, they are two whatever the poses
    constexpr double sigmas = 2;
    if (dot(a.away, b.away) < sameFace) return false;
    const bool aIsLonger = a.to - a.from >= b.to - b.from;
    const Trace& longer = aIsLonger ? a : b;
    const Trace& shorter = aIsLonger ? b : a;
    const FittedLine line = longer.fit.line();
    const double first = line.along(shorter.begin()), second = line.along(shorter.end());
    if (std::max(first, second) < longer.from - config_.maxGap) return false;
    if (std::min(first, second) > longer.to + config_.maxGap) return false;
    const double apart = std::max(line.distance(shorter.begin()), line.distance(shorter.end()));
    const double gate = exact + sigmas * std::hypot(a.sigma, b.sigma);
    return apart <= std::min(gate, widest);
}

/// Merges it with what it belongs to; that may close a gap between others.
void WallTracer::insert(Trace trace) {
    const auto fits = [&](const Trace& other) { return belongTogether(trace, other); };
    for (auto other = std::ranges::find_if(traces_, fits); other != traces_.end();
         other = std::ranges::find_if(traces_, fits)) {
        const TPoint2D ends[] = {trace.begin(), trace.end(), other->begin(), other->end()};
        const bool sameScan = trace.lastScan == other->lastScan;
        trace.scans = std::min(trace.scans + other->scans - (sameScan ? 1 : 0), scan_ + 1);
        trace.lastScan = std::max(trace.lastScan, other->lastScan);
        trace.segments += other->segments;
        if (other->to - other->from > trace.to - trace.from) trace.away = other->away;
        trace.sigma = merged(trace.sigma, other->sigma);
        trace.fit.add(other->fit);
        const FittedLine line = trace.fit.line();
        Reach reach{line.along(ends[0]), line.along(ends[0])};
        for (const TPoint2D& end : ends) reach.add(line.along(end));
        trace.from = reach.from;
        trace.to = reach.to;
        TPoint2D normal = normalOf(line);
        trace.away = dot(normal, trace.away) < 0 ? normal * -1 : normal;
        *other = traces_.back();
        traces_.pop_back();
    }
    traces_.push_back(trace);
}

void WallTracer::add(std::span<const SeenSegment> segments) {
    std::vector<SeenSegment> ofWalls(segments.begin(), segments.end());
    std::erase_if(ofWalls, [](const SeenSegment& segment) { return segment.seenOver; });
    for (const SurfaceLine& line : surfaceLines(ofWalls, config_.line)) {
        insert(traceOf(line, ofWalls));
    }
    ++scan_;
}

std::vector<TracedWall> WallTracer::walls() const {
    std::vector<TracedWall> traced;
    std::vector<core::Wall> walls;
    for (const Trace& trace : traces_) {
        if (trace.to - trace.from < config_.minLength || trace.scans < config_.minScans) continue;
        walls.push_back({.line = {trace.begin(), trace.end()},
                         .sigma = std::max(config_.sigmaSegment, trace.fit.scatter())});
        traced.push_back({{}, trace.scans, trace.segments});
    }
    closeCorners(walls, config_.maxCornerGap);
    for (size_t i = 0; i < walls.size(); ++i) traced[i].wall = walls[i];
    return traced;
}

}  // namespace offmap::evaluation
