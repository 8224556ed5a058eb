// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace offmap::accuracy {

namespace {

using evaluation::RemovalCount;
using evaluation::Score;

double percent(std::optional<double> share) { return 100 * share.value_or(NAN); }
double removed(const RemovalCount& count) { return percent(count.removedShare()); }
double kept(const RemovalCount& count) { return percent(count.keptShare()); }

const Pool& aligned(const Pools& pools) { return pools[alignedMethod]; }

/// Collects bounds; with few scans, every share may be off its limit by some percent more.
class Bounds {
 public:
    explicit Bounds(double slack) : slack_(slack) {}

    void atLeast(const std::string& what, double measured, double limit) {
        bounds_.push_back({prefix_ + what, measured, limit - slack_, false, " %"});
    }
    void atMost(const std::string& what, double measured, double limit) {
        bounds_.push_back({prefix_ + what, measured, limit + slack_, true, " %"});
    }
    void addExactly(Bound bound) {
        bound.what.insert(0, prefix_);
        bounds_.push_back(std::move(bound));
    }
    void setPrefix(const std::string& prefix) { prefix_ = prefix; }
    std::vector<Bound> take() { return std::move(bounds_); }

 private:
    double slack_;  ///< [%]
    std::string prefix_;
    std::vector<Bound> bounds_;
};

void boundPooled(const Pool& pool, bool sparse, Bounds& bounds) {
    const Score& score = pool.score.total();
    bounds.atLeast("all levels, mapped on segments removed", removed(score.mappedOnSegments), 99.3);
    bounds.atLeast("all levels, all mapped removed", removed(score.mapped), sparse ? 95.5 : 98.5);
    bounds.atMost("all levels, unmapped removed", removed(score.unmapped), 0.7);
    bounds.atMost("all levels, unmapped removed, 95th percentile of scans",
                  percent(pool.score.unmappedRemoved(0.95)), 4);
}

/// The worst cell of all; VLP-16 is allowed 3 % less of all mapped points, as over all cells.
void boundCells(const Study& cells, bool sparse, Bounds& bounds) {
    double onSegments = 100, mapped = 100, unmapped = 0;
    for (const Pools& pools : cells.pools) {
        const Score& score = aligned(pools).score.total();
        onSegments = std::min(onSegments, removed(score.mappedOnSegments));
        mapped = std::min(mapped, removed(score.mapped));
        unmapped = std::max(unmapped, removed(score.unmapped));
    }
    bounds.atLeast("worst level, mapped on segments removed", onSegments, 98.5);
    bounds.atLeast("worst level, all mapped removed", mapped, sparse ? 94.5 : 97.5);
    bounds.atMost("worst level, unmapped removed", unmapped, 1.5);
}

/// Objects that stand some way before a wall keep their points.
void boundStandOffs(const std::string& level, const Study& standOffs, Bounds& bounds) {
    RemovalCount further;
    for (size_t c = 0; c < standOffs.conditions.size(); ++c) {
        const Score& score = aligned(standOffs.pools[c]).score.total();
        // A condition's objects are those that stand at its distance; others stand in the open.
        const RemovalCount ten = score.standingOff(10, 10);
        if (standOffs.conditions[c].name == "10 cm") {
            bounds.atLeast("objects at 10 cm kept, " + level, kept(ten), 98);
        }
        further.add(score.standingOff(20, 50));
    }
    bounds.atLeast("objects at 20 to 50 cm kept, " + level, kept(further), 99);
}

void boundTooLarge(const std::string& level, const Study& lies, Bounds& bounds) {
    for (const char* factor : {"x2", "x4"}) {
        bounds.atLeast(fmt::format("stated {}, mapped on segments removed, {}", factor, level),
                       removed(aligned(lies.at(factor)).score.total().mappedOnSegments), 98);
    }
}

void boundTooSmall(const std::string& level, const Study& lies, Bounds& bounds) {
    const Pool& pool = aligned(lies.at("x0.25"));
    bounds.atMost("stated x0.25, unmapped removed, " + level, removed(pool.score.total().unmapped),
                  1);
    bounds.atMost("stated x0.25, scans kept whole, " + level, 100 * pool.keptWholeShare(), 20);
}

/// \param leastFlagged [%] of the scans
void boundBlunders(const Study& blunders, double leastFlagged, Bounds& bounds) {
    for (const char* blunder : {"0.5 m", "10 deg"}) {
        const Pool& pool = aligned(blunders.at(blunder));
        bounds.atMost(fmt::format("pose {} wrong, unmapped removed", blunder),
                      removed(pool.score.total().unmapped), 1);
        bounds.addExactly({fmt::format("pose {} wrong, scans flagged", blunder),
                           100 * pool.flaggedShare(), leastFlagged, false, " %"});
    }
}

/// The mean of the normalised squared errors of honest poses is 3, and varies by sqrt(6 / n).
/// Walls that are drawn as straight lines with ends displaced are not quite what the alignment
/// takes them for, and the last places of an edge are not Gaussian: 20 % besides three deviations.
void boundPose(const PosePool& pose, Bounds& bounds) {
    const double tolerance = 0.6 + 3 * std::sqrt(6 / double(std::max<size_t>(pose.scans, 1)));
    const double mean = pose.meanSquaredError();
    bounds.addExactly(
        {"refined pose, mean squared error, normalised", mean, 3 + tolerance, true, ""});
    bounds.addExactly(
        {"refined pose, mean squared error, normalised", mean, 3 - tolerance, false, ""});
}

void boundPaper(const Study& cells, Bounds& bounds) {
    for (size_t c = 0; c < cells.conditions.size(); ++c) {
        const Localisation& noise = cells.conditions[c].localisations.front();
        if (noise.sigmaHeading > 0.0175 || noise.sigmaPosition > 0.0301) continue;  // 1 deg, 3 cm
        const Score& score = cells.pools[c][paperMethod].score.total();
        const std::string& level = cells.conditions[c].name;
        bounds.atLeast("method paper, mapped on segments removed, " + level,
                       removed(score.mappedOnSegments), 98);
        bounds.atMost("method paper, unmapped removed, " + level, removed(score.unmapped), 5);
    }
}

}  // namespace

std::vector<Bound> boundsOf(const Studies& studies, const Extent& extent) {
    Bounds bounds(extent.quick ? 0.5 : 0);
    for (const ScannerStudies& of : studies.scanners) {
        const bool sparse = &of != &studies.scanners.front();
        bounds.setPrefix(of.scanner + ": ");
        const Pools all = of.cells.pooled();
        boundPooled(aligned(all), sparse, bounds);
        boundCells(of.cells, sparse, bounds);
        boundStandOffs("middle level", of.standOffs, bounds);
        boundStandOffs("all levels", of.standOffsMixed, bounds);
        boundTooLarge("middle level", of.lies, bounds);
        boundTooLarge("all levels", of.liesMixed, bounds);
        boundTooSmall("middle level", of.lies, bounds);
        boundTooSmall("all levels", of.liesMixed, bounds);
        // Of 25 scans, 4 may lack the flag.
        boundBlunders(of.blunders, extent.quick ? 83 : 95, bounds);
        boundPose(aligned(all).pose, bounds);
        if (!sparse) boundPaper(of.cells, bounds);
    }
    return bounds.take();
}

}  // namespace offmap::accuracy
