// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace offmap::app {

/// Prints and flushes. Where nobody listens any more (a pipe to a pager that was left, a full
/// disk), the work goes on: unlike with fmt::print(), that is no error.
template <class... Values>
void say(std::FILE* stream, fmt::format_string<Values...> format, Values&&... values) {
    const std::string text = fmt::format(format, std::forward<Values>(values)...);
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stream));
    static_cast<void>(std::fflush(stream));
}

/// Makes stdin, stdout and stderr what they are called, even if this program was started without:
/// the next file that is opened would stand for them, and what is printed land in it.
void prepareStandardStreams();

}  // namespace offmap::app
