// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ShortReason.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <new>
#include <string_view>

namespace offmap::rawlog {

std::string shortReason(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error)) return "a size in it cannot be true";
    std::string_view text = error.what();
    for (std::string_view mark : {"==== MRPT exception ====", "Original exception:", "Message:"}) {
        const size_t at = text.rfind(mark);
        if (at != std::string_view::npos) text.remove_prefix(at + mark.size());
    }
    text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size()));
    constexpr size_t longest = 160;
    std::string reason(text.substr(0, std::min(text.find('\n'), longest)));
    while (!reason.empty() && std::strchr(".!", reason.back())) reason.pop_back();
    for (char& c : reason) {
        if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
    }
    return reason;
}

}  // namespace offmap::rawlog
