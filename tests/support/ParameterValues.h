// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Parameter.h>

#include <vector>

namespace offmap::test {

/// Smallest, largest, smallest, ...: as many as a List may have at most, or four.
inline std::vector<double> ascendingPairs(const rawlog::Parameter& p) {
    std::vector<double> values(p.lengths.empty() ? 4 : p.lengths.back(), p.min);
    for (size_t i = 1; i < values.size(); i += 2) values[i] = p.max;
    return values;
}

/// The values at both ends of what is allowed.
inline std::vector<std::vector<double>> limitsOf(const rawlog::Parameter& p) {
    if (p.kind == rawlog::ParameterKind::List) return {{}, ascendingPairs(p)};
    return {{p.min}, {p.max}};
}

/// An allowed value, but not this one.
inline std::vector<double> otherThan(const rawlog::Parameter& p, const std::vector<double>& value) {
    const auto limits = limitsOf(p);
    return value == limits.back() ? limits.front() : limits.back();
}

}  // namespace offmap::test
