// SPDX-License-Identifier: BSD-3-Clause
#include "MapCheckResult.h"

#include <offmap/core/WallGeometry.h>

#include <fmt/format.h>

#include <optional>

namespace offmap::app {

using evaluation::BinCheck;
using evaluation::BinState;
using evaluation::WallCheck;

namespace {

std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
    std::string text = "\"";
    for (const char c : name) text.append(c == '"' ? 2 : 1, c);
    return text + '"';
}

std::string metres(double value) { return fmt::format("{:.4f}", value); }
std::string metres(const std::optional<double>& value) { return value ? metres(*value) : ""; }

/// Only if there is what it is the mean of.
std::string metresIf(bool known, double value) { return known ? metres(value) : ""; }

}  // namespace

BinState stateOf(const WallCheck& check) {
    if (check.seen > 0) return BinState::Seen;
    if (check.missing > 0) return BinState::Missing;
    return check.hidden > 0 ? BinState::Hidden : BinState::OutOfView;
}

std::string wallsCsv(const MapCheckResult& result) {
    std::string text =
        "wall,layer,x1_m,y1_m,x2_m,y2_m,length_m,state,seen_share,missing_share,hidden_share,"
        "segments,points,mean_m,spread_m,rms_m,largest_m,largest_at_m,left_face_m,right_face_m,"
        "segments_through,segments_in_front,clearance_m\n";
    for (const WallCheck& check : result.walls) {
        const auto& line = result.file.walls[check.wall].line;
        const bool seen = check.seen > 0;
        text += fmt::format(
            "{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{},{},"
            "{},{},{},{},{}\n",
            check.wall, quoted(result.layerOf(check)), line.point1.x, line.point1.y, line.point2.x,
            line.point2.y, check.length, toString(stateOf(check)), check.seen, check.missing,
            check.hidden, check.offset.segments, check.offset.returns,
            seen ? metres(check.offset.mean()) : "", metresIf(seen, check.spread),
            metresIf(seen, check.rms), metresIf(seen, check.largest),
            metresIf(seen, check.largestAt), metres(check.leftFace), metres(check.rightFace),
            check.through, check.inFront, metresIf(check.inFront > 0, check.clearance));
    }
    return text;
}

std::string profileCsv(const MapCheckResult& result) {
    std::string text =
        "wall,from_m,to_m,x_m,y_m,state,segments,points,mean_m,spread_m,left_face_m,right_face_m,"
        "segments_through,segments_in_front,clearance_m\n";
    for (const WallCheck& check : result.walls) {
        for (const BinCheck& bin : check.bins) {
            const auto middle = core::placeAt(result.file.walls[check.wall],
                                              0.5 * (bin.from + bin.to) / check.length);
            const bool seen = bin.state == BinState::Seen;
            text += fmt::format(
                "{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{},{},{},{},{}\n", check.wall,
                bin.from, bin.to, middle.x, middle.y, toString(bin.state), bin.offset.segments,
                bin.offset.returns, seen ? metres(bin.offset.mean()) : "",
                seen ? metres(bin.offset.deviation()) : "", metres(bin.leftFace),
                metres(bin.rightFace), bin.through, bin.inFront,
                bin.inFront > 0 ? metres(bin.clearance / static_cast<double>(bin.inFront)) : "");
        }
    }
    return text;
}

}  // namespace offmap::app
