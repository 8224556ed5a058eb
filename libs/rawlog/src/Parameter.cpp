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

using Numbers = std::vector<double>;

double toConfigUnit(const Parameter& p, double value) {
    return p.unit == "deg" ? mrpt::DEG2RAD(value) : value;
}

/// Limits are compared in the unit of Config: an angle that went there and back may be a rounding
/// error off its limit.
bool isAllowed(const Parameter& p, double valueInConfig) {
    const bool inLimits =
        toConfigUnit(p, p.min) <= valueInConfig && valueInConfig <= toConfigUnit(p, p.max);
    const bool fractions = p.kind == ParameterKind::Number || p.kind == ParameterKind::List;
    return inLimits && (fractions || valueInConfig == std::floor(valueInConfig));
}

bool areAllowed(const Parameter& p, const Numbers& valuesInConfig) {
    const bool asMany =
        p.kind == ParameterKind::List
            ? p.lengths.empty() || std::ranges::count(p.lengths, valuesInConfig.size()) > 0
            : valuesInConfig.size() == 1;
    return asMany &&
           std::ranges::all_of(valuesInConfig, [&](double value) { return isAllowed(p, value); });
}

[[noreturn]] void refuse(const Parameter& p, std::string_view text) {
    throw std::invalid_argument(
        fmt::format("{} cannot be \"{}\": allowed is {}", p.key, text, p.allowed()));
}

std::string numbersText(const Parameter& p, const Numbers& values, std::string_view format) {
    std::vector<std::string> texts;
    for (const double value : values) {
        texts.push_back(fmt::format(fmt::runtime(format), value));
    }
    const bool list = p.kind == ParameterKind::List;
    return fmt::format("{}{}{}", list ? "[" : "", fmt::join(texts, ", "), list ? "]" : "");
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

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

/// "[-15, 1]", "-15,1", "[]".
std::optional<Numbers> parseList(std::string_view text) {
    if (text.starts_with('[') != text.ends_with(']') || text == "[") return std::nullopt;
    if (text.starts_with('[')) {
        text = trimmed(text.substr(1, text.size() - 2));
        if (text.empty()) return Numbers{};
    }
    Numbers numbers;
    for (bool more = true; more;) {
        const size_t comma = text.find(',');
        const auto number = parse<double>(trimmed(text.substr(0, comma)));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        more = comma != std::string_view::npos;
        if (more) text.remove_prefix(comma + 1);
    }
    return numbers;
}

std::optional<Numbers> parse(const Parameter& p, std::string_view text) {
    std::optional<double> one;
    switch (p.kind) {
        case ParameterKind::Number:
            one = parse<double>(text);
            break;
        case ParameterKind::Count:
            one = parse<uint32_t>(text);
            break;
        case ParameterKind::Switch:
        case ParameterKind::Choice:
            one = place(p.choices, text);
            break;
        case ParameterKind::List:
            return parseList(text);
    }
    return one ? std::optional(Numbers{*one}) : std::nullopt;
}

Numbers inConfigUnit(const Parameter& p, Numbers values) {
    for (double& value : values) value = toConfigUnit(p, value);
    return values;
}

}  // namespace

std::vector<double> Parameter::numbers(const Config& config) const {
    Numbers values = read(config);
    if (unit == "deg") {
        for (double& value : values) value = mrpt::RAD2DEG(value);
    }
    return values;
}

void Parameter::setNumbers(Config& config, const std::vector<double>& values) const {
    const Numbers valuesInConfig = inConfigUnit(*this, values);
    if (!areAllowed(*this, valuesInConfig)) refuse(*this, numbersText(*this, values, "{}"));
    write(config, valuesInConfig);
}

std::string Parameter::text(const Config& config) const {
    const Numbers values = numbers(config);
    return choices.empty() ? numbersText(*this, values, "{:.12g}")
                           : std::string(choices.at(static_cast<size_t>(values.at(0))));
}

void Parameter::setText(Config& config, std::string_view text) const {
    const std::optional<Numbers> values = parse(*this, text);
    if (!values || !areAllowed(*this, inConfigUnit(*this, *values))) refuse(*this, text);
    setNumbers(config, *values);
}

std::string Parameter::allowed() const {
    const std::string inUnit = unit == "-" ? "" : fmt::format(" {}", unit);
    switch (kind) {
        case ParameterKind::Number:
            return fmt::format("{} ... {}{}", min, max, inUnit);
        case ParameterKind::Count:
            return fmt::format("a whole number, {} ... {}", min, max);
        case ParameterKind::Switch:
            return "true or false";
        case ParameterKind::Choice:
            return fmt::format("{}", fmt::join(choices, ", "));
        case ParameterKind::List:
            return fmt::format(
                "a list of {}numbers, each {} ... {}{}",
                lengths.empty() ? "" : fmt::format("{} ", fmt::join(lengths, " or ")), min, max,
                inUnit);
    }
    return {};
}

void Parameter::check(const Config& config) const {
    if (!areAllowed(*this, read(config))) {
        refuse(*this, numbersText(*this, numbers(config), "{:.12g}"));
    }
}

}  // namespace offmap::rawlog
