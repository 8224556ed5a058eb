// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/World.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace offmap::evaluation {

/// A return, what it truly comes from, and what became of it.
struct ScoredPoint {
    bool mapped = false;  ///< the map shows the surface that it comes from
    bool onVerticalSegment = false;
    bool removed = false;
    SurfaceKind kind = SurfaceKind::Object;
    std::optional<float> standOff;  ///< [m] of an object before the nearest wall of the map
};

/// How many there are, and how many of them were removed.
struct RemovalCount {
    uint64_t points = 0;
    uint64_t removed = 0;

    void add(const RemovalCount& more);
    std::optional<double> removedShare() const;  ///< [0, 1]; none without points
    std::optional<double> keptShare() const;     ///< [0, 1]; none without points
};

inline constexpr size_t surfaceKindCount = 4;

/// What was right and wrong about a reduction, in points: of one scan, or pooled over many.
struct Score {
    RemovalCount mappedOnSegments;  ///< mapped and on a vertical segment
    RemovalCount mapped;
    RemovalCount unmapped;
    std::array<RemovalCount, surfaceKindCount> unmappedByKind;  ///< by SurfaceKind
    /// Unmapped points by their stand-off, in whole centimetres; those of 1 m and more under 100.
    std::map<int, RemovalCount> unmappedByStandOff;

    void add(const ScoredPoint& point);
    void add(const Score& more);

    /// AA = sqrt(MR * UP): mapped points removed, unmapped kept. [0, 1]; none if either is missing
    std::optional<double> geometricMean() const;

    /// Unmapped points of a stand-off [cm], from and to included.
    RemovalCount standingOff(int fromCentimetres, int toCentimetres = 100) const;
};

Score scoreOf(std::span<const ScoredPoint> points);

/// The smallest of the values that at least this share of them does not exceed (nearest rank);
/// none without values. \param share in (0, 1]
std::optional<double> percentile(std::vector<double> values, double share);

/// Scores of many scans: pooled by points, and how they spread from scan to scan.
class PooledScore {
 public:
    void add(const Score& scan);
    void add(const PooledScore& more);

    const Score& total() const { return total_; }
    size_t scans() const { return scans_; }

    /// Percentiles over the scans of the share of mapped, of unmapped points removed. [0, 1]; none
    /// if no scan has such points
    std::optional<double> mappedRemoved(double share) const;
    std::optional<double> unmappedRemoved(double share) const;

 private:
    Score total_;
    size_t scans_ = 0;
    std::vector<double> mappedRemoved_;    ///< [0, 1] per scan that has mapped points
    std::vector<double> unmappedRemoved_;  ///< [0, 1] per scan that has unmapped points
};

}  // namespace offmap::evaluation
