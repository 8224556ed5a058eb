// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ReductionTotals.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offmap::rawlog {

namespace {

constexpr double leastShare = 0.3;  // of the points on vertical segments; less smells
/// Of the scans. An honest covariance is contradicted by one in a thousand.
constexpr double seldom = 0.01;

/// " (scans 4, 5, 9)"; " (the first: scans 4, 5, 9)"; "" if they are not known
std::string namesOf(const HealthTotals& health) {
    if (health.firstSuspects.empty()) return "";
    const bool all = health.firstSuspects.size() == health.suspectScans();
    return fmt::format(" ({}scan{} {})",
                       all ? "" : "the first: ", health.firstSuspects.size() == 1 ? "" : "s",
                       fmt::join(health.firstSuspects, ", "));
}

void warnOfWholeScans(const ReductionTotals& totals, std::vector<std::string>& out) {
    const auto warn = [&](const char* reason, const char* words) {
        const auto found = totals.notReduced.find(reason);
        if (found == totals.notReduced.end()) return;
        out.emplace_back(fmt::format("{} of {} scans {}", found->second, totals.scans, words));
    };
    warn("no_wall_in_range",
         "have no wall within range: check --map-origin, the map's units and the frame of the "
         "poses");
    warn("pose_does_not_fit",
         "show what fits no place near their pose, all of their points were kept: check the map "
         "and --map-origin, check the poses, or state how far off they may be (--pose-sigma, or "
         "the covariance in the log)");
}

void warnOfContradictions(const ReductionTotals& totals, std::vector<std::string>& out) {
    const uint64_t count = totals.health.suspectFor(core::Suspicion::PoseContradicted);
    if (static_cast<double>(count) <= seldom * static_cast<double>(totals.scans)) return;
    out.emplace_back(fmt::format(
        "{} of {} scans contradict the stated covariance of their poses{}; they were reduced from "
        "where they fit the map: check the poses, or state how far off they may be (--pose-sigma, "
        "or the covariance in the log)",
        count, totals.scans, namesOf(totals.health)));
}

/// Of scans that were reduced, but not as they should have been.
void warnOfPoorResults(const ReductionTotals& totals, std::vector<std::string>& out) {
    const uint64_t withoutPose = totals.keptByReason[static_cast<size_t>(core::KeepReason::NoPose)];
    const auto matchable = static_cast<double>(totals.onVerticalSegments - withoutPose);
    const auto removed = static_cast<double>(totals.removedOnSegments());
    const uint64_t few = totals.health.suspectFor(core::Suspicion::FewMatches);
    const uint64_t biased = totals.health.suspectFor(core::Suspicion::Biased);
    if (totals.onVerticalSegments == 0) {
        out.emplace_back(
            "no vertical segment was found: for a scanner with few rings raise "
            "vertical.max_gap_m and lower vertical.min_points (a VLP-16: --config vlp16)");
    } else if (totals.removed() == 0) {
        out.emplace_back("nothing was removed: check that the map and the poses share one frame");
    } else if (removed < leastShare * matchable) {
        out.emplace_back(
            fmt::format("only {:.1f} % of the points on vertical segments were removed: "
                        "check the poses against the map{}",
                        100 * removed / matchable, namesOf(totals.health)));
    } else if (static_cast<double>(few + biased) > seldom * static_cast<double>(totals.scans)) {
        out.emplace_back(fmt::format(
            "the walls of {} of {} scans are hardly, or all nearer or further, where the map has "
            "them: check the poses against the map{}",
            few + biased, totals.scans, namesOf(totals.health)));
    }
}

}  // namespace

std::vector<std::string> ReductionTotals::warnings() const {
    std::vector<std::string> out;
    for (const auto& [reason, count] : notSupported) {
        out.emplace_back(fmt::format("{} observations were copied unchanged: {}", count, reason));
    }
    warnOfWholeScans(*this, out);
    if (scans > 0 && scansNotReduced() == scans) {
        out.emplace_back("no scan could be reduced; all points were kept");
        return out;
    }
    if (scans == 0) {
        if (notSupported.empty()) {
            out.emplace_back("the log holds no 3D scan that could be reduced; it was copied");
        }
        return out;
    }
    if (counts.returns == 0) {
        out.emplace_back("the scans hold no return at all; check how the log was recorded");
        return out;
    }
    warnOfContradictions(*this, out);
    if (columnsWithoutPose > 0) {
        out.emplace_back(fmt::format(
            "{} of {} columns have no pose that could be used; all of their points were kept",
            columnsWithoutPose, columns));
    }
    warnOfPoorResults(*this, out);
    return out;
}

}  // namespace offmap::rawlog
