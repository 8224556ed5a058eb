// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace offmap::maps::svg {

/// Properties by name, of those that say whether something is seen.
using Declarations = std::map<std::string, std::string, std::less<>>;

/// What the style sheets of a document say of ".class", "#id" and "element"; other selectors are
/// not understood.
struct StyleSheet {
    std::map<std::string, Declarations, std::less<>> rules;

    void add(std::string_view css);
};

/// Whether an element is seen; children begin with what their parent has.
struct Style {
    bool isDisplayed = true;
    bool isVisible = true;
    bool isFilled = true;
    bool isStroked = false;

    bool isSeen() const { return isDisplayed && isVisible && (isFilled || isStroked); }

    /// Of a child of an element with this style.
    Style of(const pugi::xml_node& child, const StyleSheet& sheet) const;
};

}  // namespace offmap::maps::svg
