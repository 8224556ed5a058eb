// SPDX-License-Identifier: BSD-3-Clause
#include "HealthJson.h"

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

std::string keyOf(size_t keepReason) {
    return std::string(core::toString(static_cast<core::KeepReason>(keepReason)));
}

ordered_json keptJson(const std::array<uint64_t, core::keepReasonCount>& kept) {
    ordered_json out = ordered_json::object();
    for (size_t r = 1; r < kept.size(); ++r) {
        out[keyOf(r)] = kept[r];
    }
    return out;
}

/// The figures that a turn and the whole log have in common.
template <class Figures>
void addPoints(const Figures& figures, ordered_json& out) {
    for (const char* first : {"points", "points_on_vertical_segments"}) out[first] = 0;
    out["points_removed"] = figures.removed();
    forEachCount([&](const char* key, const auto& count) { out[key] = count; }, figures);
    out["points_kept_by_reason"] = keptJson(figures.keptByReason);
}

ordered_json turnJson(const TurnRecord& turn, uint64_t index) {
    ordered_json out;
    out["scan"] = index;
    out["entry"] = turn.entry;
    out["time_s"] = secondsSinceEpoch(turn.time);
    out["sensor"] = turn.label;
    out["class"] = turn.className;
    addPoints(turn, out);
    addHealth(turn.health, out);
    out["not_reduced"] = turn.notReduced.empty() ? ordered_json() : ordered_json(turn.notReduced);
    out["reduce_ms"] = rounded(turn.milliseconds);
    return out;
}

/// Labels come from a file and may hold any bytes.
std::string text(const ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

ordered_json toJson(const ReductionTotals& totals) {
    ordered_json out;
    out["scans"] = totals.scans;
    out["scans_not_reduced"] = totals.notReduced;
    out["observations_not_supported"] = totals.notSupported;
    addPoints(totals, out);
    out.update(toJson(totals.health));
    const auto median = totals.milliseconds.quantile(0.5);
    const auto p95 = totals.milliseconds.quantile(0.95);
    out["reduce_ms_median"] = median ? ordered_json(rounded(*median)) : ordered_json();
    out["reduce_ms_p95"] = p95 ? ordered_json(rounded(*p95)) : ordered_json();
    out["log_s"] = totals.logSeconds();
    return out;
}

ReductionTotals totalsFrom(const ordered_json& json) {
    ReductionTotals totals;
    totals.scans = json.at("scans");
    totals.notReduced = json.at("scans_not_reduced");
    totals.notSupported = json.at("observations_not_supported");
    forEachCount([&](const char* key, uint64_t& count) { count = json.at(key); }, totals);
    const ordered_json& kept = json.at("points_kept_by_reason");
    for (size_t r = 1; r < totals.keptByReason.size(); ++r) {
        totals.keptByReason[r] = kept.at(keyOf(r));
    }
    totals.health = healthFrom(json);
    totals.mergedLogSeconds = json.at("log_s");
    return totals;
}

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
    file_.write("\n],\n\"totals\": " + text(toJson(totals), 2));
    for (const auto& [key, value] : tail.items()) {
        file_.write(",\n" + text(key, -1) + ": " + text(value, -1));
    }
    file_.write("\n}\n");
    file_.finish();
}

}  // namespace offmap::rawlog
