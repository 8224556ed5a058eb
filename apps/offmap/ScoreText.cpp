// SPDX-License-Identifier: BSD-3-Clause
#include "ScoreText.h"

#include "TextSections.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

namespace offmap::app {

using evaluation::RemovalCount;
using evaluation::Score;
using rawlog::grouped;

namespace {

/// Finer than points are: a share that is not whole never shows as "100.00 %" or "0.00 %".
std::string percentText(const std::optional<double>& share) {
    if (!share) return fmt::format("{:>8}  ", "-");
    const double percent = 100 * *share;
    if (*share < 1 && percent > 99.99) return fmt::format("{:>8} %", ">99.99");
    if (*share > 0 && percent < 0.01) return fmt::format("{:>8} %", "<0.01");
    return fmt::format("{:8.2f} %", percent);
}

std::string ofText(uint64_t part, uint64_t whole) {
    return whole == 0 ? "   no such points"
                      : fmt::format("   {} of {}", grouped(part), grouped(whole));
}

std::string removedLine(const std::string& what, const RemovalCount& count) {
    return fmt::format("{:<28}{}{}", what, percentText(count.removedShare()),
                       ofText(count.removed, count.points));
}

std::string keptLine(const std::string& what, const RemovalCount& count) {
    return fmt::format("{:<28}{}{}", what, percentText(count.keptShare()),
                       ofText(count.points - count.removed, count.points));
}

std::vector<std::string> keptLines(const Score& score) {
    constexpr std::array names{"walls", "floor", "ceiling", "objects"};
    std::vector<std::string> lines{keptLine("not mapped (UP)", score.unmapped)};
    for (size_t k = 0; k < names.size(); ++k) {
        const RemovalCount& count = score.unmappedByKind[k];
        if (count.points > 0) lines.push_back(keptLine(fmt::format("  {}", names[k]), count));
    }
    for (const auto& [centimetres, count] : score.unmappedByStandOff) {
        lines.push_back(keptLine(
            fmt::format("  {} cm {}off a wall", centimetres, centimetres == 100 ? "and more " : ""),
            count));
    }
    return lines;
}

std::vector<std::string> scanLines(const evaluation::PooledScore& score) {
    std::vector<std::string> lines{
        fmt::format("{:<28}{:>8}  {:>9}  {:>9}", "percentile of scans", "5th", "50th", "95th")};
    std::string mapped = fmt::format("{:<28}", "mapped, removed");
    std::string unmapped = fmt::format("{:<28}", "not mapped, removed");
    for (const double share : {0.05, 0.5, 0.95}) {
        const std::string_view gap = share < 0.5 ? "" : " ";
        mapped.append(gap) += percentText(score.mappedRemoved(share));
        unmapped.append(gap) += percentText(score.unmappedRemoved(share));
    }
    lines.insert(lines.end(), {mapped, unmapped});
    return lines;
}

}  // namespace

std::string scoreText(const LogScore& score, const ScoredFiles& files) {
    const Score& total = score.score.total();
    std::string out = section("truth", {files.truth.string()});
    out += section("log", {files.log.string()});
    out += section("scans",
                   {fmt::format("{}, {}", counted(score.score.scans(), "scan"),
                                counted(total.mapped.points + total.unmapped.points, "point"))});
    out += section("removed", {removedLine("mapped, vertical segments", total.mappedOnSegments),
                               removedLine("mapped (MR)", total.mapped)});
    out += section("kept", keptLines(total));
    out += section(
        "both", {fmt::format("{:<28}{}", "AA = sqrt(MR UP)", percentText(total.geometricMean()))});
    out += section("spread", scanLines(score.score));
    return out;
}

}  // namespace offmap::app
