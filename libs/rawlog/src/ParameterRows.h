// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Parameter.h>

#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// One function for each kind of parameter, that makes it from what it is and where it stands.

namespace offmap::rawlog {

/// \param access a generic lambda from a Config to the field, constant or not
template <typename Access>
Parameter parameterRow(std::string_view key, std::string_view unit, double min, double max,
                       Access access, std::string_view meaning, ParameterKind kind,
                       std::vector<std::string_view> choices = {}) {
    using Field = std::remove_reference_t<decltype(access(std::declval<Config&>()))>;
    return {key,
            unit,
            meaning,
            kind,
            min,
            max,
            std::move(choices),
            {},
            [access](const Config& c) { return std::vector{static_cast<double>(access(c))}; },
            [access](Config& c, const std::vector<double>& values) {
                access(c) = static_cast<Field>(values.at(0));
            }};
}

template <typename Access>
Parameter number(std::string_view key, std::string_view unit, double min, double max, Access access,
                 std::string_view meaning) {
    return parameterRow(key, unit, min, max, access, meaning, ParameterKind::Number);
}

template <typename Access>
Parameter count(std::string_view key, double min, double max, Access access,
                std::string_view meaning) {
    return parameterRow(key, "-", min, max, access, meaning, ParameterKind::Count);
}

template <typename Access>
Parameter onOff(std::string_view key, Access access, std::string_view meaning) {
    return parameterRow(key, "-", 0, 1, access, meaning, ParameterKind::Switch, {"false", "true"});
}

/// \param names in the order of the enumeration's values
template <typename Access>
Parameter choice(std::string_view key, std::vector<std::string_view> names, Access access,
                 std::string_view meaning) {
    const auto last = static_cast<double>(names.size() - 1);
    return parameterRow(key, "-", 0, last, access, meaning, ParameterKind::Choice,
                        std::move(names));
}

/// \param lengths how many numbers it may hold; empty: any
/// \param read from a Config to the numbers \param write the other way
template <typename Read, typename Write>
Parameter list(std::string_view key, std::string_view unit, double min, double max,
               std::vector<size_t> lengths, Read read, Write write, std::string_view meaning) {
    return {key, unit, meaning, ParameterKind::List, min, max, {}, std::move(lengths), read, write};
}

/// Of a field that holds the numbers as they are.
template <typename Access>
Parameter list(std::string_view key, std::string_view unit, double min, double max,
               std::vector<size_t> lengths, Access access, std::string_view meaning) {
    return list(
        key, unit, min, max, std::move(lengths), access,
        [access](Config& c, const std::vector<double>& values) { access(c) = values; }, meaning);
}

}  // namespace offmap::rawlog
