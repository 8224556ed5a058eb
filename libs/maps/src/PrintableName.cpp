// SPDX-License-Identifier: BSD-3-Clause
#include "PrintableName.h"

#include <cpl_string.h>

namespace offmap::maps {

std::string printableName(std::string_view text, size_t most) {
    const bool whole = text.size() <= most;
    std::string name(text.substr(0, most));
    // a character may have been cut in two
    while (!whole && !name.empty() && (static_cast<unsigned char>(name.back()) & 0x80U) != 0) {
        name.pop_back();
    }
    const bool isUtf8 = CPLIsUTF8(name.c_str(), static_cast<int>(name.size())) != 0;
    for (char& c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !isUtf8)) c = '?';
    }
    return whole ? name : name + "...";
}

}  // namespace offmap::maps
