// SPDX-License-Identifier: BSD-3-Clause
#include "LiveText.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

namespace offmap::app {

using rawlog::grouped;

namespace {

std::string milliseconds(const rawlog::DurationHistogram& durations, double share) {
    const auto value = durations.quantile(share);
    return value ? fmt::format("{:.1f}", *value) : "-";
}

std::string rate(const std::optional<double>& perSecond) {
    return perSecond ? fmt::format("{:.1f}", *perSecond) : "-";
}

}  // namespace

std::string runningLineOf(const live::LiveFigures& figures, double seconds) {
    const uint64_t points = figures.totals.counts.returns;
    const double share =
        points == 0 ? 0 : 100.0 * double(figures.totals.removed()) / double(points);
    std::string line = fmt::format(
        "{:>7.1f} s  {:>7} turns  {:>5}/s  {:>5.1f} % removed  reduce {} ms  latency {} (p99 {}) "
        "ms",
        seconds, grouped(figures.totals.scans), rate(figures.turnsPerSecond), share,
        milliseconds(figures.totals.milliseconds, 0.5), milliseconds(figures.latency, 0.5),
        milliseconds(figures.latency, 0.99));
    if (figures.turnsDropped > 0)
        line += fmt::format("  {} dropped", grouped(figures.turnsDropped));
    if (figures.source.packetsMissing > 0) {
        line += fmt::format("  {} packets missing", grouped(figures.source.packetsMissing));
    }
    if (figures.source.state != live::SourceState::Running) {
        line += fmt::format("  {}", toString(figures.source.state));
    }
    if (!figures.source.message.empty()) line += ": " + figures.source.message;
    return line;
}

std::string liveSummaryOf(const live::LiveFigures& figures) {
    std::string text = fmt::format(
        "latency {:>9} ms   from the last of a turn to its result "
        "(median); p99 {} ms\n",
        milliseconds(figures.latency, 0.5), milliseconds(figures.latency, 0.99));
    text += fmt::format("dropped {:>12}   turns, of {} that came\n", grouped(figures.turnsDropped),
                        grouped(figures.source.received));
    if (figures.source.packetsMissing > 0) {
        text += fmt::format("missing {:>12}   packets, by the stamps of the others\n",
                            grouped(figures.source.packetsMissing));
    }
    if (figures.source.connectionsLost > 0) {
        text += fmt::format("stalled {:>12}   times, after it had run\n",
                            grouped(figures.source.connectionsLost));
    }
    if (figures.source.state == live::SourceState::Stalled) {
        text += fmt::format("source  {:>12}   {}\n", toString(figures.source.state),
                            figures.source.message);
    }
    return text;
}

}  // namespace offmap::app
