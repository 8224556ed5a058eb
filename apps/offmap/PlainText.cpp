// SPDX-License-Identifier: BSD-3-Clause
#include "PlainText.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace offmap::app {

namespace {

bool isControl(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

bool isPlain(const std::string& text) {
    if (std::ranges::any_of(text, isControl)) return false;
    try {
        static_cast<void>(nlohmann::json(text).dump());
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;  // no UTF-8
    }
}

bool needsNoQuotes(const std::string& word) {
    return !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
        return c < 0x80 && (std::isalnum(c) != 0 || std::strchr("_-+=:,./@%", c) != nullptr);
    });
}

/// `$'...'`, in which every byte can be told.
std::string ansiQuoted(const std::string& word) {
    std::string out = "$'";
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte >= 0x7f) {
            out += fmt::format("\\{:03o}", byte);
        } else {
            if (c == '\\' || c == '\'') out += '\\';
            out += c;
        }
    }
    return out + "'";
}

}  // namespace

std::string printable(const std::string& text) {
    if (isPlain(text)) return text;
    using nlohmann::json;
    const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
    return quoted.substr(1, quoted.size() - 2);
}

std::string shellWord(const std::string& word) {
    if (needsNoQuotes(word)) return word;
    if (!isPlain(word)) return ansiQuoted(word);
    std::string out = "'";
    for (const char c : word) {
        if (c == '\'') {
            out += "'\\''";
        } else {
            out += c;
        }
    }
    return out + "'";
}

std::string shellLine(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back(shellWord(word));
    return fmt::format("{}", fmt::join(quoted, " "));
}

std::string shellLines(const std::vector<std::string>& words, size_t width, size_t indent) {
    std::string out;
    size_t column = 0;
    for (size_t i = 0; i < words.size(); ++i) {
        // An option and its value stay together.
        const bool withNext =
            words[i].starts_with("-") && i + 1 < words.size() && !words[i + 1].starts_with("-");
        std::string piece = shellWord(words[i]);
        if (withNext) piece.append(" ").append(shellWord(words[++i]));
        if (column > 0 && column + 1 + piece.size() + 2 > width) {
            out.append(" \\\n").append(indent, ' ');
            column = indent;
        } else if (column > 0) {
            out += ' ';
            ++column;
        }
        out += piece;
        column += piece.size();
    }
    return out;
}

}  // namespace offmap::app
