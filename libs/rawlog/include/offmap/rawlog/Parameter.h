// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::rawlog {

/// How the value of a parameter is written.
enum class ParameterKind : uint8_t {
    Number,  ///< "0.05"
    Count,   ///< a whole number, "4"
    Switch,  ///< "true" or "false"
    Choice,  ///< one of Parameter::choices
    List,    ///< numbers, "[-15, 1]"; read without brackets, too
};

/// One adjustable value of Config under its name in files and on the command line, and in their
/// unit. Degrees become radians in this class and nowhere else.
struct Parameter {
    std::string_view key;      ///< "section.name", the name with its unit as suffix
    std::string_view unit;     ///< "m", "deg", "s"; "-" for none
    std::string_view meaning;  ///< one line, lower case, without a full stop
    ParameterKind kind;
    double min, max;                        ///< [unit] smallest and largest allowed value
    std::vector<std::string_view> choices;  ///< of a Choice; a value's place is its number
    std::vector<size_t> lengths;            ///< of a List; empty: any
    std::function<std::vector<double>(const Config&)> read;  ///< in the unit of Config
    std::function<void(Config&, const std::vector<double>&)>
        write;  ///< in the unit of Config, unchecked

    /// The values in the parameter's unit, one unless it is a List; false is 0, true is 1, a choice
    /// is its place.
    std::vector<double> numbers(const Config& config) const;
    /// \throw std::invalid_argument naming the key and what is allowed.
    void setNumbers(Config& config, const std::vector<double>& values) const;

    /// As numbers(), of what is no List.
    double number(const Config& config) const { return numbers(config).at(0); }
    void setNumber(Config& config, double value) const { setNumbers(config, {value}); }

    /// The value as one writes it in a file, to 12 digits.
    std::string text(const Config& config) const;
    /// \throw std::invalid_argument naming the key and what is allowed.
    void setText(Config& config, std::string_view text) const;

    /// "0.001 ... 1 m", "true or false", "auto, turn, column", "a list of 0 or 6 numbers,
    /// each -100 ... 100 m".
    std::string allowed() const;
    /// \throw std::invalid_argument if the value in a configuration is not allowed.
    void check(const Config& config) const;
};

}  // namespace offmap::rawlog
