// SPDX-License-Identifier: BSD-3-Clause
#include "AxisTicks.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace offmap::window {

namespace {

/// For quotients of numbers that binary fractions cannot hold, as 0.3 / 0.1.
constexpr double rounding = 1e-9;

std::string labelOf(double value, int decimals) {
    if (decimals > 0) return fmt::format("{:.{}f}", value, decimals);
    const double whole = std::round(value);
    if (std::abs(whole) >= 1e15) return fmt::format("{:.3g}", whole);
    const std::string digits = rawlog::grouped(static_cast<uint64_t>(std::abs(whole)));
    return whole < 0 ? "-" + digits : digits;
}

/// Decimals that the multiples of a round step need.
int decimalsOf(double step) {
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + rounding)), 0, 12);
}

}  // namespace

double roundUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (value <= factor * power * (1 + rounding)) return factor * power;
    }
    return 10 * power;
}

double roundDown(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {10.0, 5.0, 2.0}) {
        if (value >= factor * power * (1 - rounding)) return factor * power;
    }
    return power;
}

std::vector<AxisTick> axisTicks(double low, double high, size_t most, bool whole) {
    std::vector<AxisTick> ticks;
    const double length = high - low;
    if (!std::isfinite(length) || !(length > 0) || most == 0) return ticks;
    // Steps that an axis so far from zero cannot tell apart would never come to an end.
    const double least = std::max(std::abs(low), std::abs(high)) * 1e-12;
    double step = roundUp(std::max({length / static_cast<double>(most), least,
                                    std::numeric_limits<double>::min(), whole ? 1.0 : 0.0}));
    const auto first = [&] { return std::ceil(low / step - rounding); };
    const auto last = [&] { return std::floor(high / step + rounding); };
    while (last() - first() + 1 > static_cast<double>(most)) step = roundUp(1.5 * step);
    const int decimals = decimalsOf(step);
    for (double i = first(); i <= last(); ++i) {
        const double value = i * step + 0.0;  // no minus before zero
        ticks.push_back({value, labelOf(value, decimals)});
    }
    return ticks;
}

std::string lengthLabel(double metres) {
    const auto number = [](double value) {
        return value < 1 ? fmt::format("{:g}", value) : labelOf(value, 0);
    };
    if (metres >= 1000) return number(metres / 1000) + " km";
    if (metres >= 1) return number(metres) + " m";
    if (metres >= 0.01) return number(metres * 100) + " cm";
    return number(metres * 1000) + " mm";
}

}  // namespace offmap::window
