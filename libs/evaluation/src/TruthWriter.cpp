// SPDX-License-Identifier: BSD-3-Clause
#include "TruthColumns.h"

#include <offmap/evaluation/TruthFile.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace offmap::evaluation {

namespace {

/// As RFC 4180 has it, but in one line.
std::string quoted(const std::string& label) {
    if (label.find_first_of("\r\n") != std::string::npos) {
        throw std::invalid_argument("a truth file cannot hold a sensor label with a line break");
    }
    if (label.find_first_of(",\"") == std::string::npos) return label;
    std::string out = "\"";
    for (const char c : label) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

/// [s] since 1970, to the tick.
std::string secondsText(mrpt::Clock::time_point time) {
    const int64_t ticks = time.time_since_epoch().count() - epochTicks;
    const auto magnitude = static_cast<uint64_t>(std::abs(ticks));
    return fmt::format("{}{}.{:0{}}", ticks < 0 ? "-" : "", magnitude / ticksPerSecond,
                       magnitude % ticksPerSecond, tickDigits);
}

/// The shortest digits that read back as the same number.
void append(std::string& row, float number) {
    if (!std::isfinite(number)) {
        throw std::invalid_argument("a truth file holds finite numbers only");
    }
    char digits[32];
    row.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
    row += ',';
}

void appendRow(std::string& rows, const std::string& key, const TruePoint& truth) {
    rows += key;
    append(rows, truth.point.x);
    append(rows, truth.point.y);
    append(rows, truth.point.z);
    rows += truth.mapped ? "1," : "0,";
    rows.append(kindNames.at(static_cast<size_t>(truth.kind))).push_back(',');
    if (truth.standOff) {
        append(rows, *truth.standOff);
    } else {
        rows += ',';
    }
    rows += truth.onVerticalSegment ? "1\n" : "0\n";
}

}  // namespace

TruthWriter::TruthWriter(Sink sink) : sink_(std::move(sink)) {
    sink_(fmt::format("{}\n", truthHeader));
}

void TruthWriter::add(const ObservationTruth& observation) {
    const std::string source =
        fmt::format("{},{},", secondsText(observation.time), quoted(observation.sensor));
    if (key_.ends_with("," + source)) {
        throw std::invalid_argument("two observations of one time and label: " + source);
    }
    rows_.clear();
    const std::string key = fmt::format("{},{}", observation.scan, source);
    for (const TruePoint& truth : observation.points) appendRow(rows_, key, truth);
    if (!rows_.empty()) key_ = key;
    sink_(rows_);
}

}  // namespace offmap::evaluation
