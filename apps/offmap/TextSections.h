// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace offmap::app {

/// Lines under a key, which stands before the first of them only.
std::string section(std::string_view key, const std::vector<std::string>& lines);

/// A text in lines that a terminal shows whole beside the keys, broken at its spaces.
/// \param hang of the lines after the first
std::vector<std::string> wrapped(const std::string& text, size_t hang = 0);

/// A name, and lines to stand beside it.
using Row = std::pair<std::string, std::vector<std::string>>;
/// A section whose lines stand in a column of their own beside the names.
std::string table(std::string_view key, const std::vector<Row>& rows);

/// "1 scan", "1,200 scans"
std::string counted(uint64_t count, std::string_view what);

/// A label as it may be printed; "(no label)" for an empty one.
std::string nameOf(const std::string& label);

/// ", 9.98 Hz"; empty if not known.
std::string rateText(const std::optional<double>& rate);

}  // namespace offmap::app
