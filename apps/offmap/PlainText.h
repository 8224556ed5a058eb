// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace offmap::app {

/// Text from a log as it may be printed: one line of valid UTF-8, whatever its bytes.
std::string printable(const std::string& text);

/// One word of a shell's command line, quoted where a shell (bash, zsh, ksh) would change it.
std::string shellWord(const std::string& word);

/// A command line that a shell reads as these words.
std::string shellLine(const std::vector<std::string>& words);

/// The same, with `\` before each line break. \param width of the lines, as far
/// as the words allow \param indent of the lines after the first
std::string shellLines(const std::vector<std::string>& words, size_t width, size_t indent);

}  // namespace offmap::app
