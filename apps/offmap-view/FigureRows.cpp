// SPDX-License-Identifier: BSD-3-Clause
#include "FigureRows.h"

#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/view/Wording.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace offmap::window {

namespace {

using core::KeepReason;
using rawlog::grouped;
using Mood = FigureRow::Mood;

const std::string none = "-";

/// Three digits that matter, as far as there are decimals.
std::string threeDigits(double value) {
    if (!std::isfinite(value)) return none;
    const double size = std::abs(value);
    return fmt::format("{:.{}f}", value, size < 10 ? 2 : size < 100 ? 1 : 0);
}

std::string threeDigits(const std::optional<double>& value) {
    return value ? threeDigits(*value) : none;
}

std::string removedText(const rawlog::TurnRecord& record) {
    if (record.counts.returns == 0) return grouped(record.removed());
    return fmt::format(
        "{} ({:.1f} %)", grouped(record.removed()),
        100.0 * static_cast<double>(record.removed()) / static_cast<double>(record.counts.returns));
}

std::string spaced(std::string words) {
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

FigureRow healthRow(const live::LiveFrame* frame) {
    FigureRow row{"health", none};
    if (!frame) return row;
    const rawlog::TurnRecord& record = frame->reduced.record;
    if (record.health.suspect) {
        return {"health", "suspect: " + inWords(*record.health.suspect), Mood::Bad};
    }
    if (!record.notReduced.empty()) {
        return {"health", "kept whole: " + spaced(record.notReduced), Mood::Bad};
    }
    // Nothing was seen where the map has walls, so nothing speaks for the pose either.
    if (!record.health.matchedShare) return {"health", "no walls seen"};
    return {"health", "fits", Mood::Good};
}

std::string correctionText(const live::LiveFrame* frame) {
    if (!frame || !frame->reduced.record.health.fit) return none;
    const core::PoseFit& fit = *frame->reduced.record.health.fit;
    return fmt::format("{:.3f} m, {:.2f}\u00b0", fit.shift, mrpt::RAD2DEG(fit.turn));
}

FigureRow sourceRow(const live::SourceHealth& source) {
    const bool bad =
        source.state == live::SourceState::Stalled || source.state == live::SourceState::Failed;
    std::string text(toString(source.state));
    if (!source.message.empty()) text += ": " + source.message;
    return {"source", text, bad ? Mood::Bad : Mood::Plain};
}

FigureRow lossRow(std::string label, uint64_t lost) {
    return {std::move(label), grouped(lost), lost > 0 ? Mood::Bad : Mood::Plain};
}

void addScan(std::vector<FigureRow>& rows, const live::LiveFrame* frame) {
    rows.push_back({"points", frame ? grouped(frame->reduced.record.counts.returns) : none});
    rows.push_back({"removed", frame ? removedText(frame->reduced.record) : none});
    for (const KeepReason reason : view::keepReasons) {
        const auto index = static_cast<size_t>(reason);
        const std::string value =
            frame ? grouped(frame->reduced.record.keptByReason.at(index)) : none;
        rows.push_back(
            {fmt::format("kept: {}", view::inWords(reason)), value, Mood::Plain, reason});
    }
}

void addPace(std::vector<FigureRow>& rows, const live::LiveFigures& figures,
             const live::LiveFrame* frame) {
    const auto now = frame ? threeDigits(frame->reduced.record.milliseconds) : none;
    const auto& totals = figures.totals.milliseconds;
    rows.push_back(
        {"reduce now, median", fmt::format("{}, {} ms", now, threeDigits(totals.quantile(0.5)))});
    rows.push_back(
        {"latency median, p99", fmt::format("{}, {} ms", threeDigits(figures.latency.quantile(0.5)),
                                            threeDigits(figures.latency.quantile(0.99)))});
    rows.push_back({"turns per second", threeDigits(figures.turnsPerSecond)});
    rows.push_back(lossRow("turns dropped", figures.turnsDropped));
    rows.push_back(lossRow("packets missing", figures.source.packetsMissing));
}

}  // namespace

std::string inWords(core::Suspicion suspicion) {
    switch (suspicion) {
        case core::Suspicion::DoesNotFit:
            return "fits no place near its pose";
        case core::Suspicion::PoseContradicted:
            return "contradicts its pose's covariance";
        case core::Suspicion::FewMatches:
            return "shows few of the map's walls";
        case core::Suspicion::Biased:
            return "all walls nearer or further than mapped";
    }
    return "";
}

std::vector<FigureRow> figuresOf(const live::LiveFigures& figures, const live::LiveFrame* frame) {
    std::vector<FigureRow> rows;
    addScan(rows, frame);
    addPace(rows, figures, frame);
    rows.push_back(healthRow(frame));
    rows.push_back({"pose correction", correctionText(frame)});
    rows.push_back(sourceRow(figures.source));
    return rows;
}

}  // namespace offmap::window
