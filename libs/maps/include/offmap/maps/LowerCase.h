// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace offmap::maps {

/// A to Z as a to z, whatever the locale; all other bytes as they are.
constexpr char lowerCase(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

inline std::string lowerCase(std::string text) {
    for (char& letter : text) letter = lowerCase(letter);
    return text;
}

}  // namespace offmap::maps
