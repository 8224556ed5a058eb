// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGate.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double widestGate = 0.3;  // [m] further off, nothing is taken for a wall
/// The mean of more returns of one segment is no better: they err alike.
constexpr uint32_t countedReturns = 15;

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

/// Sine of the incidence angle below which a ray along a wall says nothing of ground ranges.
constexpr double grazing = 0.05;

double noiseOf(const WallSight& sight, const AlignmentConfig& config) {
    const double sigma = sight.rangeSigma.value_or(config.sigmaRange);
    return sigma * sigma / std::min(sight.returns, countedReturns);
}

/// Notes what the map has a wall for at the ground range that the segment is `behind` of, across
/// the wall, and what may be off by the gate. \param across sine of the incidence angle
void predict(double behind, double sigma, double across, double gate, SegmentMatch& match) {
    match.residual = sigma > 0 ? behind / sigma : 0;
    match.predicted.reset();
    if (across < grazing) return;
    match.predicted =
        Interval::around(match.measured.centre() - behind / across, gate * sigma / across);
}

/// [m^2] Of how far a place stands off a wall: pose, map and noise. All is told times the squared
/// length of the normal that the gradient goes by.
double varianceAcross(const Wall& wall, const PoseCorrection& correction, const Vector5& gradient,
                      double squaredNormal, double noise) {
    return gradient.dot(correction.covariance * gradient) +
           squaredNormal * wall.sigma * wall.sigma + noise;
}

}  // namespace

double varianceOfSight(const WallSight& sight, const TPoint2D& normal,
                       const AlignmentConfig& config) {
    const double along = sight.rangeSigma.value_or(config.sigmaRange) * dot(normal, sight.beam);
    return along * along / std::min(sight.returns, countedReturns);
}

WallOffset offsetFrom(const LineMap& map, uint32_t index, const PoseCorrection& correction,
                      const CorrectedColumn& column, const SeenPoint& point, const TPoint2D& beam,
                      double noise) {
    const Wall& wall = map.walls()[index];
    const TPoint2D place = column.place(point);
    const TPoint2D normal = map.normalAwayFrom(beam, index, place);
    const Vector5 gradient = column.gradient(point, normal);
    const double across = dot(normal, beam);
    const double variance = varianceAcross(wall, correction, gradient, 1, across * across * noise);
    return {distanceBehind(place, wall, normal), std::sqrt(variance), across};
}

bool isWithinGate(const LineMap& map, uint32_t index, const PoseCorrection& correction,
                  const CorrectedColumn& column, const SeenPoint& point, double noise,
                  double gate) {
    const Wall& wall = map.walls()[index];
    const double squaredRange = point.ground.sqrNorm();
    if (wall.curvature != 0 || squaredRange == 0) {
        const TPoint2D beam =
            squaredRange > 0 ? point.ground * (1 / std::sqrt(squaredRange)) : TPoint2D(1, 0);
        const WallOffset offset = offsetFrom(map, index, correction, column, point, beam, noise);
        return distanceTo(wall, column.place(point)) <= gate * offset.sigma;
    }
    // All is told times the wall's length, or its square.
    const TPoint2D along = wall.line.point2 - wall.line.point1, normal(-along.y, along.x);
    const double squaredLength = along.sqrNorm();
    const TPoint2D from = column.place(point) - wall.line.point1;
    const double behind = dot(normal, from), share = dot(along, from);
    const double beyond = std::max({-share, share - squaredLength, 0.0});
    const double across = dot(normal, point.ground);
    const Vector5 gradient = column.gradient(point, normal);
    const double variance = varianceAcross(wall, correction, gradient, squaredLength,
                                           across * across / squaredRange * noise);
    return behind * behind + beyond * beyond <= gate * gate * variance;
}

namespace {

/// What a ray through the segment tells of one that stands on no wall.
void explainKept(const WallSight& sight, const PoseCorrection& correction,
                 const CorrectedColumn& column, const LineMap& map, const ReductionConfig& config,
                 SegmentMatch& match) {
    const TPoint2D from = column.place({{0, 0}, 0});
    TPoint2D ray = column.place(sight.middle()) - from;
    const double range = ray.norm();
    match.reason = KeepReason::NoWallOnRay;
    if (!(range > 0)) return;
    ray = ray * (1 / range);
    const auto hit = map.castRay(from, ray, config.matching.maxRange, sight.heightInMap);
    if (!hit) return;
    match.wall = hit->wall;
    match.reason = range < hit->range ? KeepReason::InFrontOfWall : KeepReason::BehindWall;
    const double across = hit->incidence.sine();
    const WallOffset offset = offsetFrom(map, hit->wall, correction, column, sight.middle(),
                                         sight.beam, noiseOf(sight, config.alignment));
    predict((range - hit->range) * across, offset.sigma, across, config.alignment.gate, match);
}

}  // namespace

SegmentMatch matchByGate(const WallSight& sight, const Interval& measured,
                         const PoseCorrection& correction, const Turn& turn, const LineMap& map,
                         const ReductionConfig& config) {
    SegmentMatch match;
    const CorrectedColumn column(correction, turn, sight.place);
    match.measured = measured;
    const TPoint2D place = column.place(sight.middle());
    const auto near = map.nearestWall(place, widestGate, sight.heightInMap);
    if (near) {
        const WallOffset offset = offsetFrom(map, near->wall, correction, column, sight.middle(),
                                             sight.beam, noiseOf(sight, config.alignment));
        const double gate = config.alignment.gate;
        if (near->distance <= gate * offset.sigma) {
            predict(offset.behind, offset.sigma, offset.across, gate, match);
            match.verdict = Verdict::MappedByRay;
            match.reason = KeepReason::None;
            match.wall = near->wall;
            return match;
        }
    }
    explainKept(sight, correction, column, map, config, match);
    return match;
}

}  // namespace offmap::core
