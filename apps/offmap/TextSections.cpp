// SPDX-License-Identifier: BSD-3-Clause
#include "TextSections.h"

#include "PlainText.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

namespace {

constexpr size_t keyWidth = 10, lineWidth = 100;

}  // namespace

std::string section(std::string_view key, const std::vector<std::string>& lines) {
    std::string out;
    for (size_t i = 0; i < lines.size(); ++i) {
        out += fmt::format("{:<{}}{}\n", i == 0 ? key : "", keyWidth, lines[i]);
    }
    return out;
}

std::vector<std::string> wrapped(const std::string& text, size_t hang) {
    std::vector<std::string> lines(1);
    bool fresh = true;
    size_t at = 0;
    while (at < text.size()) {
        const size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!fresh && lines.back().size() + 1 + word.size() > lineWidth - keyWidth) {
            lines.emplace_back(hang, ' ');
            fresh = true;
        }
        lines.back().append(fresh ? 0 : 1, ' ').append(word);
        fresh = false;
        at = end + 1;
    }
    return lines;
}

std::string table(std::string_view key, const std::vector<Row>& rows) {
    size_t width = 0;
    for (const Row& row : rows) width = std::max(width, row.first.size());
    std::vector<std::string> all;
    for (const auto& [name, lines] : rows) {
        for (size_t i = 0; i < lines.size(); ++i) {
            all.push_back(fmt::format("{:<{}}  {}", i == 0 ? name : "", width, lines[i]));
        }
    }
    return section(key, all);
}

std::string counted(uint64_t count, std::string_view what) {
    return fmt::format("{} {}{}", rawlog::grouped(count), what, count == 1 ? "" : "s");
}

std::string nameOf(const std::string& label) {
    return label.empty() ? "(no label)" : printable(label);
}

std::string rateText(const std::optional<double>& rate) {
    if (!rate) return "";
    return *rate < 999.5 ? fmt::format(", {:.3g} Hz", *rate)
                         : fmt::format(", {} Hz",
                                       rawlog::grouped(static_cast<uint64_t>(std::llround(*rate))));
}

}  // namespace offmap::app
