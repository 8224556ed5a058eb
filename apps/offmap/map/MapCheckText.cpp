// SPDX-License-Identifier: BSD-3-Clause
#include "../PlainText.h"
#include "../TextSections.h"
#include "MapCheckResult.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace offmap::app {

using evaluation::BinState;
using evaluation::WallCheck;
using nlohmann::ordered_json;

namespace {

/// All walls together, weighted by their lengths.
struct Totals {
    double length = 0, seen = 0, missing = 0, hidden = 0;  // [m]
    size_t wallsSeen = 0;
    double sum = 0, squares = 0;  // [m^2], [m^3]: offsets times lengths seen

    void add(const WallCheck& check) {
        length += check.length;
        seen += check.seen * check.length;
        missing += check.missing * check.length;
        hidden += check.hidden * check.length;
        if (!(check.seen > 0)) return;
        ++wallsSeen;
        sum += check.offset.mean() * check.seen * check.length;
        squares += check.rms * check.rms * check.seen * check.length;
    }
    double mean() const { return seen > 0 ? sum / seen : 0; }
    double rms() const { return seen > 0 ? std::sqrt(squares / seen) : 0; }
    double percent(double part) const { return length > 0 ? 100 * part / length : 0; }
};

Totals totalsOf(const MapCheckResult& result) {
    Totals totals;
    for (const WallCheck& check : result.walls) totals.add(check);
    return totals;
}

std::string nameOf(const MapCheckResult& result, const WallCheck& check) {
    const auto& line = result.file.walls[check.wall].line;
    const std::string& layer = result.layerOf(check);
    return fmt::format("wall {}{}{}, ({:.2f}, {:.2f}) to ({:.2f}, {:.2f})", check.wall,
                       layer.empty() ? "" : " of ", layer.empty() ? "" : printable(layer),
                       line.point1.x, line.point1.y, line.point2.x, line.point2.y);
}

/// The first few, and how many more there are.
template <class Text>
std::vector<std::string> firstOf(const std::vector<const WallCheck*>& checks, Text&& text) {
    constexpr size_t most = 5;
    std::vector<std::string> lines;
    for (size_t i = 0; i < std::min(most, checks.size()); ++i) lines.push_back(text(*checks[i]));
    if (checks.size() > most) lines.push_back(fmt::format("and {} more", checks.size() - most));
    return lines;
}

std::vector<std::string> worstWalls(const MapCheckResult& result) {
    constexpr double leastSeen = 0.5;  // [m] of a wall, to be judged
    constexpr size_t most = 5;
    std::vector<const WallCheck*> checks;
    for (const WallCheck& check : result.walls) {
        if (check.seen * check.length >= leastSeen) checks.push_back(&check);
    }
    std::ranges::stable_sort(checks, std::greater(), [](const WallCheck* c) { return c->rms; });
    checks.resize(std::min(most, checks.size()));
    return firstOf(checks, [&](const WallCheck& check) {
        return fmt::format("rms {:.3f} m, mean {:+.3f}, at most {:+.3f} at {:.1f} of {:.1f} m: {}",
                           check.rms, check.offset.mean(), check.largest, check.largestAt,
                           check.length, nameOf(result, check));
    });
}

std::vector<std::string> unseenWalls(const MapCheckResult& result) {
    std::vector<const WallCheck*> checks;
    for (const WallCheck& check : result.walls) {
        if (!(check.seen > 0)) checks.push_back(&check);
    }
    std::ranges::stable_sort(checks, std::greater(), [](const WallCheck* c) { return c->length; });
    return firstOf(checks, [&](const WallCheck& check) {
        const BinState state = stateOf(check);
        return fmt::format("{:.1f} m, {}: {}", check.length,
                           state == BinState::Missing  ? "looked through"
                           : state == BinState::Hidden ? "things in front"
                                                       : "out of view",
                           nameOf(result, check));
    });
}

}  // namespace

std::string summaryText(const MapCheckResult& result) {
    const Totals totals = totalsOf(result);
    std::string text = section("map", {result.mapText});
    text += section("scans",
                    {fmt::format("{} of {}, {} used; poses moved by ({:+.3f}, {:+.3f}) m "
                                 "in the mean to fit",
                                 result.scans, counted(result.logs, "log"),
                                 result.scans - result.notUsed, result.shift.x, result.shift.y)});
    text += section("walls",
                    {fmt::format("{} of {} seen; of their length {:.0f} % seen, {:.0f} % "
                                 "hidden, {:.0f} % missing",
                                 totals.wallsSeen, result.walls.size(), totals.percent(totals.seen),
                                 totals.percent(totals.hidden), totals.percent(totals.missing))});
    if (totals.wallsSeen > 0) {
        text += section("offset", {fmt::format("rms {:.3f} m, mean {:+.3f} m (positive: behind the "
                                               "drawn wall)",
                                               totals.rms(), totals.mean())});
    }
    text += section("worst", worstWalls(result));
    return text + section("not seen", unseenWalls(result));
}

namespace {

ordered_json toJson(const MapCheckResult& result, const WallCheck& check) {
    const auto& line = result.file.walls[check.wall].line;
    ordered_json json{{"wall", check.wall},
                      {"layer", result.layerOf(check)},
                      {"ends_m", {line.point1.x, line.point1.y, line.point2.x, line.point2.y}},
                      {"length_m", check.length},
                      {"state", toString(stateOf(check))},
                      {"seen_share", check.seen},
                      {"missing_share", check.missing},
                      {"hidden_share", check.hidden},
                      {"segments", check.offset.segments},
                      {"points", check.offset.returns}};
    if (check.seen > 0) {
        json["mean_m"] = check.offset.mean();
        json["spread_m"] = check.spread;
        json["rms_m"] = check.rms;
        json["largest_m"] = check.largest;
        json["largest_at_m"] = check.largestAt;
    }
    if (check.leftFace) json["left_face_m"] = *check.leftFace;
    if (check.rightFace) json["right_face_m"] = *check.rightFace;
    json["segments_through"] = check.through;
    json["segments_in_front"] = check.inFront;
    if (check.inFront > 0) json["clearance_m"] = check.clearance;
    return json;
}

}  // namespace

std::string checkJson(const MapCheckResult& result) {
    const Totals totals = totalsOf(result);
    ordered_json json{{"map", result.mapText},
                      {"logs", result.logs},
                      {"scans", result.scans},
                      {"scans_not_used", result.notUsed},
                      {"mean_pose_shift_m", {result.shift.x, result.shift.y}},
                      {"length_m", totals.length},
                      {"seen_m", totals.seen},
                      {"missing_m", totals.missing},
                      {"hidden_m", totals.hidden},
                      {"mean_m", totals.mean()},
                      {"rms_m", totals.rms()},
                      {"walls", ordered_json::array()}};
    for (const WallCheck& check : result.walls) json["walls"].push_back(toJson(result, check));
    // Names come from the file, in whatever encoding.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace offmap::app
