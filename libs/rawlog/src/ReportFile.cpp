// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ReportFile.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>

namespace offmap::rawlog {

using nlohmann::ordered_json;

namespace {

double secondsSinceEpoch(mrpt::Clock::time_point time) { return mrpt::Clock::toDouble(time); }

/// To the microsecond: what is beyond is noise and makes a file hard to read.
double rounded(double milliseconds) { return std::round(1000 * milliseconds) / 1000; }

ordered_json keptJson(const std::array<uint64_t, core::keepReasonCount>& kept) {
    ordered_json out = ordered_json::object();
    for (size_t r = 1; r < kept.size(); ++r) {
        out[std::string(core::toString(static_cast<core::KeepReason>(r)))] = kept[r];
    }
    return out;
}

/// The figures that a turn and the whole log have in common.
template <class Figures>
void addPoints(const Figures& figures, ordered_json& out) {
    out["points"] = figures.counts.returns;
    out["points_on_vertical_segments"] = figures.onVerticalSegments;
    out["points_removed"] = figures.removed();
    out["points_removed_by_ray"] = figures.removedByRay;
    out["points_removed_by_extension"] = figures.removedByExtension;
    out["points_removed_as_orphans"] = figures.removedAsOrphans;
    out["points_kept_by_reason"] = keptJson(figures.keptByReason);
    out["slots_without_return"] = figures.counts.zero;
    out["points_not_finite"] = figures.counts.nonFinite;
    out["points_duplicate"] = figures.counts.duplicates;
    out["columns"] = figures.columns;
    out["columns_without_pose"] = figures.columnsWithoutPose;
}

ordered_json turnJson(const TurnRecord& turn, uint64_t index) {
    ordered_json out;
    out["scan"] = index;
    out["entry"] = turn.entry;
    out["time_s"] = secondsSinceEpoch(turn.time);
    out["sensor"] = turn.label;
    out["class"] = turn.className;
    addPoints(turn, out);
    out["not_reduced"] = turn.notReduced.empty() ? ordered_json() : ordered_json(turn.notReduced);
    out["reduce_ms"] = rounded(turn.milliseconds);
    return out;
}

ordered_json totalsJson(const ReductionTotals& totals) {
    ordered_json out;
    out["scans"] = totals.scans;
    out["scans_not_reduced"] = totals.notReduced;
    out["observations_not_supported"] = totals.notSupported;
    addPoints(totals, out);
    const auto median = totals.milliseconds.quantile(0.5);
    const auto p95 = totals.milliseconds.quantile(0.95);
    out["reduce_ms_median"] = median ? ordered_json(rounded(*median)) : ordered_json();
    out["reduce_ms_p95"] = p95 ? ordered_json(rounded(*p95)) : ordered_json();
    out["log_s"] = totals.logSeconds();
    return out;
}

/// Labels come from a file and may hold any bytes.
std::string text(const ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

void ReportFile::begin(const ordered_json& head) {
    file_.write("{\n");
    for (const auto& [key, value] : head.items()) {
        file_.write(text(key, -1) + ": " + text(value, -1) + ",\n");
    }
    file_.write("\"scans\": [");
}

void ReportFile::add(const TurnRecord& turn) {
    file_.write((scans_ == 0 ? "\n" : ",\n") + text(turnJson(turn, scans_), -1));
    ++scans_;
}

void ReportFile::finish(const ReductionTotals& totals, const ordered_json& tail) {
    file_.write("\n],\n\"totals\": " + text(totalsJson(totals), 2));
    for (const auto& [key, value] : tail.items()) {
        file_.write(",\n" + text(key, -1) + ": " + text(value, -1));
    }
    file_.write("\n}\n");
    file_.finish();
}

}  // namespace offmap::rawlog
