// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterFacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

namespace offmap::window {

namespace {

using rawlog::Parameter;
using rawlog::ParameterKind;

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> headings{{
    {"vertical", "Vertical segments"},
    {"ground_interval", "Ground intervals"},
    {"matching", "Matching"},
    {"alignment", "Alignment and gate"},
    {"extension", "Horizontal extension"},
    {"orphan", "Orphans"},
    {"sensor", "Sensor"},
    {"pose", "Poses"},
    {"odometry", "Odometry"},
    {"map", "Map"},
}};

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

std::string defaultText(const Parameter& p) { return p.text(rawlog::Config{}); }

bool isCount(const Parameter& p) { return p.kind == ParameterKind::Count; }

std::string stepHint(const Parameter& p) {
    if (p.kind != ParameterKind::Number && !isCount(p)) return {};
    return fmt::format("\nArrow keys and wheel: steps of {:.12g}, with Shift of {:.12g}", stepOf(p),
                       10 * stepOf(p));
}

}  // namespace

std::string_view sectionOf(const Parameter& p) { return p.key.substr(0, p.key.find('.')); }

std::string nameOf(const Parameter& p) {
    std::string name(p.key.substr(sectionOf(p).size() + 1));
    const std::string suffix = fmt::format("_{}", p.unit);
    if (name.ends_with(suffix)) name.resize(name.size() - suffix.size());
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string headingOf(std::string_view section) {
    const auto* const found =
        std::ranges::find(headings, section, &std::pair<std::string_view, std::string_view>::first);
    return std::string(found == headings.end() ? section : found->second);
}

bool isFoundBy(const Parameter& p, std::string_view text) {
    const std::string all =
        lowerCase(fmt::format("{} {} {} {}", p.key, nameOf(p), headingOf(sectionOf(p)), p.meaning));
    std::istringstream words(lowerCase(text));
    for (std::string word; words >> word;) {
        if (all.find(word) == std::string::npos) return false;
    }
    return true;
}

bool isDefault(const Parameter& p, const rawlog::Config& config) {
    return p.text(config) == defaultText(p);
}

bool actsAtOnce(const Parameter& p) {
    const std::string_view section = sectionOf(p);
    if (section == "pose" || section == "odometry" || section == "map") return false;
    return p.key != "sensor.columns_per_turn" && p.key != "sensor.max_column_pause_s";
}

std::string hintOf(const Parameter& p) {
    std::string meaning(p.meaning);
    meaning.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning.front())));
    return fmt::format("{}\nAllowed: {}\nDefault: {}\nKey: {}{}{}", meaning, p.allowed(),
                       defaultText(p), p.key, stepHint(p),
                       actsAtOnce(p) ? "" : "\nActs when a log, a map or a source is opened.");
}

double stepOf(const Parameter& p) {
    const double size = std::abs(p.number(rawlog::Config{}));
    if (size == 0) return isCount(p) ? 1 : std::pow(10, std::round(std::log10(p.max / 1000)));
    // 1e-9: in degrees, 3 may be a rounding error less
    const double power = std::floor(std::log10(size) + 1e-9);
    const double step = std::pow(10, size < 2.9 * std::pow(10, power) ? power - 1 : power);
    return isCount(p) ? std::max(step, 1.0) : step;
}

std::string stepped(const Parameter& p, const std::string& text, int steps) {
    double value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || !std::isfinite(value)) return defaultText(p);
    const double step = stepOf(p);
    const double whole = std::round(value / step + steps) * step;
    return fmt::format("{:.12g}", std::clamp(whole, p.min, p.max));
}

}  // namespace offmap::window
