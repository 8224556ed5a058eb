// SPDX-License-Identifier: BSD-3-Clause
#include "RootOfSquares.h"

#include <offmap/core/MapMatching.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

TPoint2D rotated(const TPoint2D& direction, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
}

/// [m^2] Variance of a wall's predicted ground range: position and map, which err independently.
double varianceOfPrediction(const Viewpoint& viewpoint, const TPoint2D& direction,
                            const Wall& wall) {
    return viewpoint.ellipse.squaredRadius(direction) + wall.sigma * wall.sigma;
}

Interval predictedInterval(const RayHit& hit, double variance, const MatchingConfig& config) {
    return Interval::around(hit.range, config.sigmaFactor * std::sqrt(variance));
}

/// Whether a ray turned by so much [rad] may at all meet a wall that fits. Most of what is kept
/// stands free: one look-up tells, no ray is needed.
bool mayFitBeside(const Interval& measured, const Viewpoint& viewpoint, const TPoint2D& direction,
                  double widest, const LineMap& map, const MatchingConfig& config) {
    const double sigma = rootOfSquares(viewpoint.ellipse.semiMajor(), map.largestSigma());
    const double range = measured.centre();
    const double reach =
        0.5 * measured.width() + config.sigmaFactor * sigma + std::abs(range) * widest;
    constexpr double rounding = 1e-6;  // [m]
    return map.hasWallWithin(viewpoint.position + direction * range, reach + rounding);
}

/// A wall that the ray may meet within the heading's uncertainty, and that fits: section 3.4,
/// figure 6.
std::optional<uint32_t> wallBesideRay(const Interval& measured, const Viewpoint& viewpoint,
                                      const TPoint2D& direction, double z, const LineMap& map,
                                      const MatchingConfig& config,
                                      std::optional<uint32_t> wallOnRay) {
    const double widest = config.sigmaFactor * viewpoint.sigmaHeading;
    if (!(widest > 0)) return std::nullopt;
    if (!mayFitBeside(measured, viewpoint, direction, widest, map, config)) return std::nullopt;
    for (const double share : {-1.0, -0.5, 0.5, 1.0}) {
        const TPoint2D beside = rotated(direction, share * widest);
        const auto hit = map.castRay(viewpoint.position, beside, config.maxRange, z);
        if (!hit || hit->wall == wallOnRay) continue;
        const double variance = varianceOfPrediction(viewpoint, beside, map.walls()[hit->wall]);
        if (predictedInterval(*hit, variance, config).intersects(measured)) return hit->wall;
    }
    return std::nullopt;
}

}  // namespace

Viewpoint viewpointOf(const SensorPose& sensor) {
    const auto& covariance = sensor.groundCovariance;
    return {{sensor.sensorInMap.x(), sensor.sensorInMap.y()},
            sensor.sensorInMap.z(),
            PositionEllipse(covariance.topLeftCorner<2, 2>()),
            std::sqrt(std::max(covariance(2, 2), 0.0))};
}

std::optional<PoseFault> faultOf(const Viewpoint& viewpoint, const MatchingConfig& config) {
    for (const double x : {viewpoint.position.x, viewpoint.position.y, viewpoint.height,
                           viewpoint.ellipse.semiMajor(), viewpoint.sigmaHeading}) {
        if (!std::isfinite(x)) return PoseFault::NotFinite;
    }
    // Conditioned on the scan, a pose may begin with less: whether it was found shows in the scan.
    const double start = config.method == MatchingMethod::Aligned ? 4 : 1;
    if (config.sigmaFactor * viewpoint.ellipse.semiMajor() > start * config.maxPositionRadius ||
        config.sigmaFactor * viewpoint.sigmaHeading > start * config.maxHeadingError) {
        return PoseFault::TooUncertain;
    }
    return std::nullopt;
}

void matchByRay(const VerticalSegment& segment, const Viewpoint& viewpoint, const LineMap& map,
                const MatchingConfig& config, SegmentMatch& match) {
    const Interval measured = match.measured;
    const double groundRange = segment.centre.norm();
    const TPoint2D direction =
        groundRange > 0 ? segment.centre * (1 / groundRange) : TPoint2D(1, 0);
    const double z = viewpoint.height + 0.5 * (segment.bottom.y + segment.top.y);
    const auto hit = map.castRay(viewpoint.position, direction, config.maxRange, z);
    if (hit) {
        const double variance = varianceOfPrediction(viewpoint, direction, map.walls()[hit->wall]);
        match.wall = hit->wall;
        match.predicted = predictedInterval(*hit, variance, config);
        // What the measured interval is wide stands for the noise of the sensor and the mounting.
        const double sigmaMeasured = 0.5 * measured.width() / std::max(config.sigmaFactor, 1.0);
        const double total = std::sqrt(variance + sigmaMeasured * sigmaMeasured);
        match.residual = total > 0 ? (measured.centre() - hit->range) / total : 0;
        if (match.predicted->intersects(measured)) {  // eq. 7, corrected
            match.verdict = Verdict::MappedByRay;
            match.reason = KeepReason::None;
            return;
        }
        match.reason = measured.max() < match.predicted->min() ? KeepReason::InFrontOfWall
                                                               : KeepReason::BehindWall;
    } else {
        match.reason = KeepReason::NoWallOnRay;
    }
    const auto beside = wallBesideRay(measured, viewpoint, direction, z, map, config, match.wall);
    if (beside) {
        match.reason = KeepReason::AmbiguousCorner;
        match.wall = beside;
    }
}

}  // namespace offmap::core
