// SPDX-License-Identifier: BSD-3-Clause
#include "SvgStyle.h"

#include "SvgValues.h"

#include <algorithm>
#include <array>

namespace offmap::maps::svg {

namespace {

constexpr std::array<std::string_view, 8> understood{
    "display", "visibility",   "opacity",      "fill",
    "stroke",  "fill-opacity", "stroke-width", "stroke-opacity"};
constexpr std::string_view blanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The text up to a mark, which is taken off with it; all of it if there is none.
std::string_view takeUpTo(std::string_view& text, char mark) {
    const size_t end = std::min(text.find(mark), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return taken;
}

/// "fill: none; stroke: black !important"
void declare(std::string_view text, Declarations& declarations) {
    while (!text.empty()) {
        std::string_view value = takeUpTo(text, ';');
        const std::string_view name = trimmed(takeUpTo(value, ':'));
        value = trimmed(value.substr(0, value.find('!')));
        if (std::ranges::find(understood, name) == understood.end()) continue;
        declarations[std::string(name)] = value;
    }
}

std::string withoutComments(std::string_view css) {
    std::string text;
    for (size_t begin = 0; begin < css.size();) {
        const size_t comment = std::min(css.find("/*", begin), css.size());
        text += css.substr(begin, comment - begin);
        const size_t end = css.find("*/", std::min(comment + 2, css.size()));
        begin = end == std::string_view::npos ? css.size() : end + 2;
    }
    return text;
}

std::string_view localName(std::string_view name) { return name.substr(name.find(':') + 1); }

bool isZero(const std::string& value) {
    const auto length = lengthOf(value, 100);
    return length && *length == 0;
}

}  // namespace

void StyleSheet::add(std::string_view css) {
    const std::string text = withoutComments(css);
    std::string_view rest = text;
    while (!trimmed(rest).empty()) {
        std::string_view selectors = takeUpTo(rest, '{');
        const std::string_view body = takeUpTo(rest, '}');
        while (!selectors.empty()) {
            const std::string_view selector = trimmed(takeUpTo(selectors, ','));
            if (selector.empty() || selector.find_first_of(" >+~:[@*") != std::string_view::npos)
                continue;
            declare(body, rules[std::string(selector)]);
        }
    }
}

Style Style::of(const pugi::xml_node& child, const StyleSheet& sheet) const {
    Declarations own;
    for (const std::string_view name : understood) {
        if (const auto attribute = child.attribute(name.data())) {
            own[std::string(name)] = trimmed(attribute.value());
        }
    }
    const auto apply = [&](const std::string& selector) {
        const auto rule = sheet.rules.find(selector);
        if (rule == sheet.rules.end()) return;
        for (const auto& [name, value] : rule->second) own[name] = value;
    };
    if (!sheet.rules.empty()) {
        apply(std::string(localName(child.name())));
        std::string_view classes = child.attribute("class").value();
        while (!classes.empty()) apply('.' + std::string(trimmed(takeUpTo(classes, ' '))));
        apply('#' + std::string(child.attribute("id").value()));
    }
    declare(child.attribute("style").value(), own);

    Style style = *this;
    for (const auto& [name, value] : own) {
        if (value.empty() || value == "inherit") continue;
        if (name == "display") style.isDisplayed &= value != "none";
        if (name == "opacity") style.isDisplayed &= !isZero(value);
        if (name == "visibility") style.isVisible = value == "visible";
        // in the order of their names, so that an opacity of 0 has the last word
        if (name == "fill") style.isFilled = value != "none" && value != "transparent";
        if (name == "fill-opacity") style.isFilled &= !isZero(value);
        if (name == "stroke") style.isStroked = value != "none" && value != "transparent";
        if (name == "stroke-opacity" || name == "stroke-width") style.isStroked &= !isZero(value);
    }
    return style;
}

}  // namespace offmap::maps::svg
