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

/// Ground range at which the segment's beam meets the wall, and what may be off by the gate; none
/// along the wall, where a ray says nothing.
std::optional<Interval> predictedBy(const WallOffset& offset, const Interval& measured,
                                    double across, double gate) {
    constexpr double grazing = 0.05;  // sine of the incidence angle
    if (across < grazing) return std::nullopt;
    return Interval::around(measured.centre() - offset.behind / across,
                            gate * offset.sigma / across);
}

/// What a ray through the segment tells of one that stands on no wall.
void explainKept(const WallSight& sight, const PoseCorrection& correction, const LineMap& map,
                 const MatchingConfig& config, SegmentMatch& match) {
    const TPoint2D from = correction.apply(sight.place, {{0, 0}, 0});
    const TPoint2D ray = correction.apply(sight.place, sight.middle()) - from;
    const double range = ray.norm();
    match.reason = KeepReason::NoWallOnRay;
    if (!(range > 0)) return;
    const auto hit = map.castRay(from, ray * (1 / range), config.maxRange, sight.heightInMap);
    if (!hit) return;
    match.wall = hit->wall;
    match.reason = range < hit->range ? KeepReason::InFrontOfWall : KeepReason::BehindWall;
}

}  // namespace

double varianceOfSight(const WallSight& sight, const TPoint2D& normal,
                       const AlignmentConfig& config) {
    const double along = sight.rangeSigma.value_or(config.sigmaRange) * dot(normal, sight.beam);
    return along * along / std::min(sight.returns, countedReturns);
}

WallOffset offsetFrom(const Wall& wall, const PoseCorrection& correction, const ColumnPlace& column,
                      const SeenPoint& point, const TPoint2D& beam, double noise) {
    const TPoint2D place = correction.apply(column, point);
    const TPoint2D normal = normalAwayFrom(beam, wall, place);
    const Vector5 gradient = correction.gradient(column, point, normal);
    const double across = dot(normal, beam);
    const double variance = gradient.dot(correction.covariance * gradient) +
                            wall.sigma * wall.sigma + across * across * noise;
    return {distanceBehind(place, wall, normal), distanceTo(wall, place), std::sqrt(variance)};
}

SegmentMatch matchByGate(const WallSight& sight, const Interval& measured,
                         const PoseCorrection& correction, const LineMap& map,
                         const ReductionConfig& config) {
    SegmentMatch match;
    match.measured = measured;
    const TPoint2D place = correction.apply(sight.place, sight.middle());
    const auto near = map.nearestWall(place, widestGate, sight.heightInMap);
    if (near) {
        const Wall& wall = map.walls()[near->wall];
        const double sigma = sight.rangeSigma.value_or(config.alignment.sigmaRange);
        const double noise = sigma * sigma / std::min(sight.returns, countedReturns);
        const WallOffset offset =
            offsetFrom(wall, correction, sight.place, sight.middle(), sight.beam, noise);
        const double gate = config.alignment.gate;
        match.residual = offset.sigma > 0 ? offset.behind / offset.sigma : 0;
        match.predicted = predictedBy(
            offset, measured, dot(normalAwayFrom(sight.beam, wall, place), sight.beam), gate);
        if (offset.distance <= gate * offset.sigma) {
            match.verdict = Verdict::MappedByRay;
            match.reason = KeepReason::None;
            match.wall = near->wall;
            return match;
        }
    }
    explainKept(sight, correction, map, config.matching, match);
    return match;
}

}  // namespace offmap::core
