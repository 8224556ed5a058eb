// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Score.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace offmap::evaluation {

namespace {

constexpr int furthestClass = 100;  // [cm]

int classOf(float standOff) {
    const float centimetres = std::round(100 * standOff);
    if (!(centimetres < float(furthestClass))) return furthestClass;
    return static_cast<int>(centimetres);
}

}  // namespace

void RemovalCount::add(const RemovalCount& more) {
    points += more.points;
    removed += more.removed;
}

std::optional<double> RemovalCount::removedShare() const {
    if (points == 0) return std::nullopt;
    return static_cast<double>(removed) / static_cast<double>(points);
}

std::optional<double> RemovalCount::keptShare() const {
    if (points == 0) return std::nullopt;
    return static_cast<double>(points - removed) / static_cast<double>(points);
}

void Score::add(const ScoredPoint& point) {
    const RemovalCount one{1, point.removed};
    if (point.mapped) {
        mapped.add(one);
        if (point.onVerticalSegment) mappedOnSegments.add(one);
        return;
    }
    unmapped.add(one);
    unmappedByKind[static_cast<size_t>(point.kind)].add(one);
    if (point.standOff) unmappedByStandOff[classOf(*point.standOff)].add(one);
}

void Score::add(const Score& more) {
    mappedOnSegments.add(more.mappedOnSegments);
    mapped.add(more.mapped);
    unmapped.add(more.unmapped);
    for (size_t k = 0; k < surfaceKindCount; ++k) unmappedByKind[k].add(more.unmappedByKind[k]);
    for (const auto& [centimetres, count] : more.unmappedByStandOff) {
        unmappedByStandOff[centimetres].add(count);
    }
}

std::optional<double> Score::geometricMean() const {
    const auto removed = mapped.removedShare(), kept = unmapped.keptShare();
    if (!removed || !kept) return std::nullopt;
    return std::sqrt(*removed * *kept);
}

RemovalCount Score::standingOff(int fromCentimetres, int toCentimetres) const {
    RemovalCount sum;
    for (const auto& [centimetres, count] : unmappedByStandOff) {
        if (centimetres >= fromCentimetres && centimetres <= toCentimetres) sum.add(count);
    }
    return sum;
}

Score scoreOf(std::span<const ScoredPoint> points) {
    Score score;
    for (const ScoredPoint& point : points) score.add(point);
    return score;
}

std::optional<double> percentile(std::vector<double> values, double share) {
    if (values.empty()) return std::nullopt;
    // The margin keeps a share such as 0.95 of 20 values at the 19th, in spite of rounding.
    const double rank = std::ceil(share * static_cast<double>(values.size()) - 1e-9);
    const auto index = static_cast<size_t>(std::max(rank - 1, 0.0));
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(std::min(index, values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void PooledScore::add(const Score& scan) {
    total_.add(scan);
    ++scans_;
    if (const auto share = scan.mapped.removedShare()) mappedRemoved_.push_back(*share);
    if (const auto share = scan.unmapped.removedShare()) unmappedRemoved_.push_back(*share);
}

void PooledScore::add(const PooledScore& more) {
    total_.add(more.total_);
    scans_ += more.scans_;
    mappedRemoved_.insert(mappedRemoved_.end(), more.mappedRemoved_.begin(),
                          more.mappedRemoved_.end());
    unmappedRemoved_.insert(unmappedRemoved_.end(), more.unmappedRemoved_.begin(),
                            more.unmappedRemoved_.end());
}

std::optional<double> PooledScore::mappedRemoved(double share) const {
    return percentile(mappedRemoved_, share);
}

std::optional<double> PooledScore::unmappedRemoved(double share) const {
    return percentile(unmappedRemoved_, share);
}

}  // namespace offmap::evaluation
