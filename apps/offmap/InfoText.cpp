// SPDX-License-Identifier: BSD-3-Clause
#include "InfoText.h"

#include "AdviceText.h"
#include "InfoPoseText.h"
#include "InfoSensorText.h"
#include "PlainText.h"
#include "TextSections.h"
#include "UtcTime.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace offmap::app {

using rawlog::grouped;

namespace {

std::string sizeText(uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    if (size < 1e6) return fmt::format("{:.1f} kB", size / 1e3);
    return size < 1e9 ? fmt::format("{:.1f} MB", size / 1e6) : fmt::format("{:.1f} GB", size / 1e9);
}

std::string formatText(const rawlog::EntryCounts& counts) {
    std::vector<std::string> parts;
    if (counts.observations > 0) parts.push_back(counted(counts.observations, "observation"));
    if (counts.actionCollections > 0) {
        parts.push_back(counted(counts.actionCollections, "action collection"));
    }
    if (counts.sensoryFrames > 0) parts.push_back(counted(counts.sensoryFrames, "sensory frame"));
    if (counts.nothing > 0) parts.push_back(fmt::format("{} empty", grouped(counts.nothing)));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string logSection(const LogFacts& facts) {
    std::vector<std::string> lines{
        fmt::format("{}: {}{}", printable(facts.file.string()), sizeText(facts.fileBytes),
                    facts.gzip ? fmt::format(" (gzip, {} unpacked)", sizeText(facts.unpackedBytes))
                               : " (not compressed)"),
        formatText(facts.inventory->entries())};
    if (!facts.damage.empty()) {
        const auto damage =
            wrapped("damaged, what follows is what stands before: " + printable(facts.damage));
        lines.insert(lines.end(), damage.begin(), damage.end());
    }
    return section("log", lines);
}

/// "12.3", "88,314,444"
std::string secondsText(double seconds) {
    return seconds < 1e4 ? fmt::format("{:.1f}", seconds)
                         : grouped(static_cast<uint64_t>(std::llround(seconds)));
}

std::string timeSection(const LogFacts& facts) {
    const auto& span = facts.inventory->span();
    const uint64_t without = facts.inventory->entries().withoutTime;
    std::vector<std::string> lines;
    if (span) {
        const double seconds =
            mrpt::Clock::toDouble(span->end) - mrpt::Clock::toDouble(span->begin);
        lines.push_back(seconds > 0 ? fmt::format("{} to {}, {} s", utcText(span->begin),
                                                  utcText(span->end), secondsText(seconds))
                                    : utcText(span->begin));
    }
    if (without > 0) lines.push_back(counted(without, "observation") + " without a valid time");
    return section("time", lines);
}

}  // namespace

std::string infoText(const LogFacts& facts, const Advice& advice) {
    return logSection(facts) + timeSection(facts) + scannerSection(*facts.inventory) +
           othersSection(*facts.inventory) + poseSection(facts.poses) + adviceText(advice);
}

}  // namespace offmap::app
