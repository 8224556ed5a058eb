// SPDX-License-Identifier: BSD-3-Clause
#include "HealthText.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

#include <vector>

namespace offmap::app {

using core::Suspicion;
using rawlog::grouped;

namespace {

std::string inWords(Suspicion reason) {
    switch (reason) {
        case Suspicion::DoesNotFit:
            return "fit no place near their pose and were kept whole";
        case Suspicion::PoseContradicted:
            return "contradict the stated covariance of their pose";
        case Suspicion::FewMatches:
            return "show few of the map's walls";
        case Suspicion::Biased:
            return "show all walls nearer or further than the map";
    }
    return "";
}

std::string suspectText(const rawlog::HealthTotals& health) {
    const uint64_t suspects = health.suspectScans();
    std::vector<std::string> parts;
    for (size_t r = 0; r < health.suspects.size(); ++r) {
        if (health.suspects[r] == 0) continue;
        parts.push_back(
            fmt::format("{} {}", grouped(health.suspects[r]), inWords(static_cast<Suspicion>(r))));
    }
    std::string out =
        fmt::format("\nsuspect {:>12}   {}", grouped(suspects), fmt::join(parts, ", "));
    if (health.firstSuspects.empty()) return out;
    const bool all = health.firstSuspects.size() == suspects;
    return out + fmt::format(": scan{} {}{}", suspects == 1 ? "" : "s",
                             fmt::join(health.firstSuspects, ", "), all ? "" : ", ...");
}

}  // namespace

std::string healthText(const rawlog::ReductionTotals& totals) {
    const rawlog::HealthTotals& health = totals.health;
    const uint64_t suspects = health.suspectScans();
    if (suspects == 0 && health.corrected == 0) return "";
    const uint64_t reducedSuspects = suspects - health.suspectFor(Suspicion::DoesNotFit);
    const uint64_t healthy = totals.scans - totals.scansNotReduced() - reducedSuspects;
    std::string out = fmt::format("\nhealth  {:>12}   scans fit the map", grouped(healthy));
    if (const auto shift = health.shiftRms()) {
        out += fmt::format("; poses corrected by {:.3f} m, {:.2f} deg (RMS)", *shift,
                           mrpt::RAD2DEG(*health.turnRms()));
    }
    return suspects == 0 ? out : out + suspectText(health);
}

}  // namespace offmap::app
