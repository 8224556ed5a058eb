// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/GroupedDigits.h>

namespace offmap::rawlog {

std::string grouped(uint64_t number) {
    std::string digits = std::to_string(number);
    for (size_t behind = 3; behind < digits.size(); behind += 4) {
        digits.insert(digits.size() - behind, 1, ',');
    }
    return digits;
}

}  // namespace offmap::rawlog
