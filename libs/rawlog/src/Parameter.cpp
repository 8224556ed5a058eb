// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Parameter.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

double toConfigUnit(const Parameter& p, double value) {
    return p.unit == "deg" ? mrpt::DEG2RAD(value) : value;
}

/// Limits are compared in the unit of Config: an angle that went there and back may be a rounding
/// error off its limit.
bool isAllowed(const Parameter& p, double valueInConfig) {
    const bool inLimits =
        toConfigUnit(p, p.min) <= valueInConfig && valueInConfig <= toConfigUnit(p, p.max);
    return inLimits &&
           (p.kind == ParameterKind::Number || valueInConfig == std::floor(valueInConfig));
}

[[noreturn]] void refuse(const Parameter& p, std::string_view text) {
    throw std::invalid_argument(
        fmt::format("{} cannot be \"{}\": allowed is {}", p.key, text, p.allowed()));
}

template <typename T>
std::optional<double> parse(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return static_cast<double>(value);
}

std::optional<double> place(const std::vector<std::string_view>& names, std::string_view text) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) return std::nullopt;
    return static_cast<double>(found - names.begin());
}

std::optional<double> parse(const Parameter& p, std::string_view text) {
    switch (p.kind) {
        case ParameterKind::Number:
            return parse<double>(text);
        case ParameterKind::Count:
            return parse<uint32_t>(text);
        case ParameterKind::Switch:
        case ParameterKind::Choice:
            return place(p.choices, text);
    }
    return std::nullopt;
}

}  // namespace

double Parameter::number(const Config& config) const {
    const double value = read(config);
    return unit == "deg" ? mrpt::RAD2DEG(value) : value;
}

void Parameter::setNumber(Config& config, double value) const {
    const double valueInConfig = toConfigUnit(*this, value);
    if (!isAllowed(*this, valueInConfig)) refuse(*this, fmt::format("{}", value));
    write(config, valueInConfig);
}

std::string Parameter::text(const Config& config) const {
    const double value = number(config);
    return choices.empty() ? fmt::format("{:.12g}", value)
                           : std::string(choices.at(static_cast<size_t>(value)));
}

void Parameter::setText(Config& config, std::string_view text) const {
    const std::optional<double> value = parse(*this, text);
    if (!value || !isAllowed(*this, toConfigUnit(*this, *value))) refuse(*this, text);
    setNumber(config, *value);
}

std::string Parameter::allowed() const {
    switch (kind) {
        case ParameterKind::Number:
            return fmt::format("{} ... {}{}", min, max,
                               unit == "-" ? "" : fmt::format(" {}", unit));
        case ParameterKind::Count:
            return fmt::format("a whole number, {} ... {}", min, max);
        case ParameterKind::Switch:
            return "true or false";
        case ParameterKind::Choice:
            return fmt::format("{}", fmt::join(choices, ", "));
    }
    return {};
}

void Parameter::check(const Config& config) const {
    if (!isAllowed(*this, read(config))) refuse(*this, fmt::format("{:.12g}", number(config)));
}

}  // namespace offmap::rawlog
