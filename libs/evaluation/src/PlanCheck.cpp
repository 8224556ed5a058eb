// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/PlanCheck.h>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

using core::Wall;
using mrpt::math::TPoint2D;

namespace {

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }
double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

PlanCheck::PlanCheck(const core::LineMap& map, const PlanCheckConfig& config)
    : map_(map), config_(config), bins_(map.walls().size()) {}

size_t PlanCheck::binsOf(uint32_t wall) const {
    const double bins = std::round(lengthOf(map_.walls()[wall]) / config_.binLength);
    return std::max(size_t{1}, static_cast<size_t>(bins));
}

size_t PlanCheck::binAt(uint32_t wall, double share) const {
    const size_t bins = binsOf(wall);
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(bins);
    return std::min(static_cast<size_t>(place), bins - 1);
}

PlanCheck::Bin& PlanCheck::binOf(uint32_t wall, size_t bin) {
    auto& bins = bins_[wall];
    if (bins.empty()) {
        bins.assign(binsOf(wall), {OffsetTally(config_.gate), OffsetTally(config_.gate)});
    }
    return bins[bin];
}

/// None if the segment is no piece of the wall. \param along the surface's direction; null: unknown
std::optional<PlanCheck::Stand> PlanCheck::standAt(uint32_t index, const SeenSegment& segment,
                                                   const TPoint2D* along) const {
    constexpr double pastEnd = 0.05;           // [m]
    constexpr double maxSine = 0.35;           // of 20 degrees between surface and wall
    constexpr double gateOfUnknown = 1.0 / 3;  // of the gate, for what lies on no line
    const Wall& wall = map_.walls()[index];
    const TPoint2D away = normalAwayFrom(segment.place - segment.sensor, wall, segment.place);
    const double behind = distanceBehind(segment.place, wall, away);
    const double gate = config_.gate * (along ? 1 : gateOfUnknown);
    if (!(std::abs(behind) <= gate)) return std::nullopt;
    if (distanceTo(wall, segment.place) > std::abs(behind) + pastEnd) return std::nullopt;
    if (along && std::abs(dot(*along, away)) > maxSine) return std::nullopt;
    const double share = std::clamp(shareAlong(wall, segment.place), 0.0, 1.0);
    constexpr double step = 1e-3;  // of the way, for the direction of an arc
    const TPoint2D way = placeAt(wall, share + step) - placeAt(wall, share - step);
    return Stand{index, binAt(index, share), behind, cross(way, away) < 0};
}

void PlanCheck::addOne(const SeenSegment& segment, const TPoint2D* along) {
    TPoint2D beam = segment.place - segment.sensor;
    const double range = beam.norm();
    if (!(range > 0)) return;
    beam = beam * (1 / range);
    const double z = segment.height.centre();
    const auto hit = map_.castRay(segment.sensor, beam, config_.maxRange, z);
    std::optional<Stand> stand;
    const auto near = map_.nearestWall(segment.place, config_.gate, z);
    if (near) stand = standAt(near->wall, segment, along);
    // Beside a corner the nearest wall may be the one that the surface only ends at.
    if (!stand && hit) stand = standAt(hit->wall, segment, along);
    if (stand) {
        Bin& bin = binOf(stand->wall, stand->bin);
        (stand->fromLeft ? bin.left : bin.right)
            .add(stand->behind, segment.height.width(), segment.returns);
    }
    if (!hit || (stand && stand->wall == hit->wall)) return;
    const double behind = (range - hit->range) * hit->incidence.sine();
    if (stand && behind <= config_.gate) return;  // a wall before another one is no thing
    const double share = shareAlong(map_.walls()[hit->wall], segment.sensor + beam * hit->range);
    Bin& bin = binOf(hit->wall, binAt(hit->wall, share));
    if (behind > config_.gate) ++bin.through;
    if (behind < 0) {
        ++bin.inFront;
        bin.clearance -= behind;
    }
}

void PlanCheck::add(std::span<const SeenSegment> segments) {
    const std::vector<SurfaceLine> lines = surfaceLines(segments, config_.line);
    std::vector<const TPoint2D*> along(segments.size(), nullptr);
    for (const SurfaceLine& line : lines) {
        for (const uint32_t s : line.segments) along[s] = &line.direction;
    }
    for (size_t s = 0; s < segments.size(); ++s) addOne(segments[s], along[s]);
}

}  // namespace offmap::evaluation
