// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SegmentsFile.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <iterator>
#include <optional>

namespace offmap::rawlog {

namespace {

constexpr std::string_view header =
    "scan,entry,sensor,time_s,column,azimuth_deg,points,z_min_m,z_max_m,tilt_deg,measured_min_m,"
    "measured_max_m,predicted_min_m,predicted_max_m,residual,verdict,reason,wall,"
    "points_removed,suspect\n";

/// As RFC 4180 has it. Labels come from a file and may hold any bytes.
std::string quoted(const std::string& label) {
    if (label.find_first_of(",\"\r\n") == std::string::npos) return label;
    std::string out = "\"";
    for (const char c : label) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

/// To the millimetre or 0.001 degrees; never "-0.000".
std::string fixed(double value) {
    const double rounded = std::round(1000 * value) / 1000;
    return fmt::format("{:.3f}", rounded == 0 ? 0 : rounded);
}

std::string fixedOrEmpty(const std::optional<core::Interval>& interval,
                         double (core::Interval::*end)() const) {
    return interval ? fixed(((*interval).*end)()) : "";
}

/// [m] of the levelled sensor, over the map's origin or, without a pose, over the vehicle's.
double heightOf(const core::ScanColumn& column) {
    return column.sensor ? column.sensor->sensorInMap.z() : column.sensorInVehicle.z;
}

std::string matchFields(const core::SegmentMatch& match) {
    using core::Interval;
    const bool kept = match.verdict == core::Verdict::Kept;
    return fmt::format("{},{},{},{},{},{},{},{}", fixed(match.measured.min()),
                       fixed(match.measured.max()), fixedOrEmpty(match.predicted, &Interval::min),
                       fixedOrEmpty(match.predicted, &Interval::max),
                       match.predicted ? fixed(match.residual) : "", core::toString(match.verdict),
                       kept ? core::toString(match.reason) : "",
                       match.wall ? fmt::format("{}", *match.wall) : "");
}

}  // namespace

SegmentsFile::SegmentsFile(const std::filesystem::path& target, const OutputOptions& options)
    : file_(target, options) {
    file_.write(header);
}

std::string SegmentsFile::rowsOf(uint64_t scan, const ReducedTurn& turn,
                                 const core::ReductionResult& result) {
    std::string rows;
    const std::string label = quoted(turn.record.label);
    const auto& suspect = turn.record.health.suspect;
    const std::string_view suspicion = suspect ? core::toString(*suspect) : "";
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const core::VerticalSegment& segment = result.segments[s];
        const core::ScanColumn& column = turn.organized.scan.columns[segment.column];
        const double height = heightOf(column);
        fmt::format_to(std::back_inserter(rows), "{},{},{},{:.6f},{},{},{},{},{},{},{},{},{}\n",
                       scan, turn.record.entry, label, mrpt::Clock::toDouble(column.time),
                       segment.column, fixed(mrpt::RAD2DEG(double{column.azimuth})),
                       turn.returnsPerSegment[s], fixed(height + segment.bottom.y),
                       fixed(height + segment.top.y), fixed(mrpt::RAD2DEG(segment.tilt())),
                       matchFields(result.matches[s]), turn.removedPerSegment[s], suspicion);
    }
    return rows;
}

}  // namespace offmap::rawlog
