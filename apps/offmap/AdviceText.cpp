// SPDX-License-Identifier: BSD-3-Clause
#include "AdviceText.h"

#include "PlainText.h"
#include "TextSections.h"

#include <fmt/format.h>

namespace offmap::app {

namespace {

constexpr size_t lineWidth = 100;

std::vector<std::string> stepLines(const std::vector<AdviceStep>& steps, size_t& number) {
    std::vector<std::string> lines;
    for (const AdviceStep& step : steps) {
        const std::string option = optionText(step);
        const auto all = wrapped(
            fmt::format("{}. {}{}", ++number, option.empty() ? "" : option + "  ", step.what), 3);
        lines.insert(lines.end(), all.begin(), all.end());
    }
    return lines;
}

}  // namespace

std::string optionText(const AdviceStep& step) { return shellLine(step.words); }

std::string adviceText(const Advice& advice) {
    if (!advice.hasScans) {
        return section(
            "missing",
            wrapped("3D scans: there is nothing to reduce. offmap reduces Velodyne scans, point "
                    "clouds, rotating scans, depth images, and 2D scanners that turn about the "
                    "vertical"));
    }
    size_t number = 0;
    std::string out =
        section("missing", advice.missing.empty() ? std::vector<std::string>{"nothing"}
                                                  : stepLines(advice.missing, number));
    out += section("advice", stepLines(advice.hints, number));
    out += "\n" + shellLines(advice.command, lineWidth, 4) + "\n";
    return out;
}

}  // namespace offmap::app
