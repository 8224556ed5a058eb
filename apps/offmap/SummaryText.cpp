// SPDX-License-Identifier: BSD-3-Clause
#include "SummaryText.h"

#include "HealthText.h"

#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/view/Wording.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace offmap::app {

using rawlog::grouped;
using rawlog::ReductionTotals;

namespace {

double percent(uint64_t part, uint64_t whole) {
    return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string inWords(const std::string& reason) {
    std::string words = reason;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

/// "in front of a wall 68 %, behind a wall 32 %", the most frequent first.
std::string keptText(const ReductionTotals& totals, uint64_t kept) {
    std::vector<std::pair<uint64_t, std::string>> reasons;
    for (size_t r = 0; r < totals.keptByReason.size(); ++r) {
        if (totals.keptByReason[r] == 0) continue;
        reasons.emplace_back(totals.keptByReason[r],
                             view::inWords(static_cast<core::KeepReason>(r)));
    }
    if (totals.keptOffWall > 0) reasons.emplace_back(totals.keptOffWall, "off its segment's wall");
    std::stable_sort(reasons.begin(), reasons.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> parts;
    for (const auto& [count, words] : reasons) {
        parts.push_back(fmt::format("{} {:.0f} %", words, percent(count, kept)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string scansText(const ReductionTotals& totals) {
    std::vector<std::string> parts;
    for (const auto& [reason, count] : totals.notReduced) {
        parts.push_back(fmt::format("{} {}", grouped(count), inWords(reason)));
    }
    return parts.empty() ? "" : fmt::format("   (kept whole: {})", fmt::join(parts, ", "));
}

/// "(by ray 90 %, by extension 10 %)"
std::string removedText(const ReductionTotals& totals) {
    std::vector<std::string> parts;
    const auto add = [&](uint64_t count, const char* how) {
        parts.push_back(fmt::format("{} {:.0f} %", how, percent(count, totals.removed())));
    };
    add(totals.removedByRay, "by ray");
    add(totals.removedByExtension, "by extension");
    if (totals.removedAsOrphans > 0) add(totals.removedAsOrphans, "orphans");
    if (totals.removedByPoint > 0) add(totals.removedByPoint, "by point");
    return fmt::format("({})", fmt::join(parts, ", "));
}

std::string skippedText(const ReductionTotals& totals) {
    std::vector<std::string> parts;
    const auto add = [&](uint64_t count, const char* what) {
        if (count > 0) parts.push_back(fmt::format("{} {}", grouped(count), what));
    };
    add(totals.counts.nonFinite, "not finite, kept");
    add(totals.counts.duplicates, "repeat another");
    add(totals.counts.self, "of the robot itself, kept");
    return parts.empty() ? "" : fmt::format("   ({})", fmt::join(parts, ", "));
}

}  // namespace

std::string summaryOf(const ReductionTotals& totals, double wallSeconds) {
    const uint64_t onSegments = totals.onVerticalSegments, removed = totals.removed();
    const uint64_t kept = totals.keptOnSegments();
    std::string out = fmt::format("scans   {:>12}{}\n", grouped(totals.scans), scansText(totals));
    out += fmt::format("points  {:>12}   on vertical segments {} ({:.1f} %){}\n",
                       grouped(totals.counts.returns), grouped(onSegments),
                       percent(onSegments, totals.counts.returns), skippedText(totals));
    out += fmt::format("removed {:>12}   {:.1f} % of those, {:.1f} % of all", grouped(removed),
                       percent(totals.removedOnSegments(), onSegments),
                       percent(removed, totals.counts.returns));
    if (removed > 0) out += "   " + removedText(totals);
    out += fmt::format("\nkept    {:>12}   of those", grouped(kept));
    if (kept > 0) out += ": " + keptText(totals, kept);
    if (totals.columnsWithoutPose > 0) {
        out += fmt::format("\nposes   {:>12}   of {} columns have none that could be used",
                           grouped(totals.columnsWithoutPose), grouped(totals.columns));
    }
    out += healthText(totals);
    if (const auto median = totals.milliseconds.quantile(0.5)) {
        out += fmt::format("\ntime    {:>9.2f} ms   per scan (median); {:.1f} s in all", *median,
                           wallSeconds);
        if (totals.logSeconds() > 0) {
            out += fmt::format(", {:.0f}x real time", totals.logSeconds() / wallSeconds);
        }
    }
    return out + "\n";
}

std::string summaryLineOf(const ReductionTotals& totals, const std::string& name,
                          size_t nameWidth) {
    return fmt::format("{:{}}  {:>7} scans {:>12} points {:>5.1f} % removed{}\n", name, nameWidth,
                       grouped(totals.scans), grouped(totals.counts.returns),
                       percent(totals.removed(), totals.counts.returns), scansText(totals));
}

uint64_t sizeOf(const std::filesystem::path& file) {
    std::error_code error;
    const uint64_t size = std::filesystem::file_size(file, error);
    return error ? 0 : size;
}

std::string sizeText(uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    return size < 1e6 ? fmt::format("{:.1f} kB", size / 1e3) : fmt::format("{:.1f} MB", size / 1e6);
}

}  // namespace offmap::app
