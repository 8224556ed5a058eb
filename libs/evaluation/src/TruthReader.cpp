// SPDX-License-Identifier: BSD-3-Clause
#include "GzipLines.h"
#include "TruthColumns.h"

#include <offmap/evaluation/TruthFile.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace offmap::evaluation {

namespace {

/// A field as it may be printed: in quotes, short, without control bytes.
std::string shown(std::string_view field) {
    constexpr size_t maxShown = 40;
    std::string out = "'";
    for (const char c : field.substr(0, maxShown)) {
        const auto byte = static_cast<unsigned char>(c);
        out += byte >= 0x20 && byte < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
    }
    return out + (field.size() > maxShown ? "...'" : "'");
}

/// Takes the fields of a row, one after the other.
struct Row {
    std::string_view rest;
    const GzipLines& lines;

    std::string_view field() {
        const size_t comma = rest.find(',');
        if (comma == std::string_view::npos) {
            lines.fail("too few fields; a row has those of the first line");
        }
        const std::string_view taken = rest.substr(0, comma);
        rest.remove_prefix(comma + 1);
        return taken;
    }

    /// Quoted as in RFC 4180 where it holds commas.
    std::string label() {
        if (!rest.starts_with('"')) return std::string(field());
        std::string out;
        for (size_t i = 1; i < rest.size(); ++i) {
            if (rest[i] != '"') {
                out += rest[i];
            } else if (rest.substr(i).starts_with("\"\"")) {
                out += rest[i++];
            } else if (rest.substr(i).starts_with("\",")) {
                rest.remove_prefix(i + 2);
                return out;
            } else {
                break;
            }
        }
        lines.fail("the quotes of the sensor's label do not end before a comma");
    }

    template <class Number>
    Number number(std::string_view text, std::string_view name) const {
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size()) fail(name, text, "a number");
        return value;
    }

    float finite(std::string_view text, std::string_view name) const {
        const auto value = number<float>(text, name);
        if (!std::isfinite(value)) fail(name, text, "finite");
        return value;
    }

    bool zeroOrOne(std::string_view text, std::string_view name) const {
        if (text != "0" && text != "1") fail(name, text, "0 or 1");
        return text == "1";
    }

    [[noreturn]] void fail(std::string_view name, std::string_view text,
                           std::string_view expected) const {
        lines.fail(fmt::format("{} is {}, not {}", name, shown(text), expected));
    }
};

/// [s] since 1970, with as many digits behind the point as a tick has.
mrpt::Clock::time_point timeOf(std::string_view text, const Row& row) {
    const bool negative = text.starts_with('-');
    const size_t point = std::min(text.find('.'), text.size());
    const std::string_view whole = text.substr(negative, point - negative);
    const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
    constexpr size_t longestWhole = 11;  // digits; what a tick counter can hold
    if (fraction.size() != tickDigits || whole.size() > longestWhole) {
        row.fail("time_s", text, "seconds with 7 decimals");
    }
    const int64_t ticks =
        row.number<uint32_t>(fraction, "time_s") +
        ticksPerSecond * static_cast<int64_t>(row.number<uint64_t>(whole, "time_s"));
    return mrpt::Clock::time_point(mrpt::Clock::duration(epochTicks + (negative ? -ticks : ticks)));
}

SurfaceKind kindOf(std::string_view text, const Row& row) {
    const auto* const found = std::ranges::find(kindNames, text);
    if (found == kindNames.end()) row.fail("kind", text, "wall, floor, ceiling or object");
    return static_cast<SurfaceKind>(found - kindNames.begin());
}

TruePoint pointOf(Row row) {
    TruePoint truth;
    truth.point.x = row.finite(row.field(), "x_m");
    truth.point.y = row.finite(row.field(), "y_m");
    truth.point.z = row.finite(row.field(), "z_m");
    truth.mapped = row.zeroOrOne(row.field(), "mapped");
    truth.kind = kindOf(row.field(), row);
    if (const std::string_view text = row.field(); !text.empty()) {
        truth.standOff = row.finite(text, "stand_off_m");
    }
    truth.onVerticalSegment = row.zeroOrOne(row.rest, "on_vertical_segment");
    return truth;
}

/// What precedes the points of an observation.
ObservationTruth beginOf(Row& row) {
    ObservationTruth begin;
    begin.scan = row.number<uint64_t>(row.field(), "scan");
    begin.time = timeOf(row.field(), row);
    begin.sensor = row.label();
    return begin;
}

}  // namespace

TruthReader::TruthReader(const std::filesystem::path& file)
    : lines_(std::make_unique<GzipLines>(file)) {
    const auto header = lines_->next();
    if (!header) throw std::runtime_error(file.string() + " is empty; it should hold ground truth");
    if (*header != truthHeader) {
        lines_->fail(fmt::format("not a truth file, which begins with {}", truthHeader));
    }
    if (const auto row = lines_->next()) ahead_ = *row;
}

TruthReader::~TruthReader() = default;

const ObservationTruth* TruthReader::next() {
    if (!ahead_) return nullptr;
    Row first{*ahead_, *lines_};
    ObservationTruth begin = beginOf(first);
    begin.points = std::move(current_.points);  // keeps their memory
    begin.points.clear();
    current_ = std::move(begin);
    key_ = ahead_->substr(0, ahead_->size() - first.rest.size());
    current_.points.push_back(pointOf(first));
    ahead_.reset();
    while (const auto row = lines_->next()) {
        if (!row->starts_with(key_)) {
            ahead_ = *row;
            break;
        }
        current_.points.push_back(pointOf({row->substr(key_.size()), *lines_}));
    }
    return &current_;
}

}  // namespace offmap::evaluation
