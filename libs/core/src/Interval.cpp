// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Interval.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace offmap::core {

void Interval::refuse() const {
    throw std::invalid_argument("interval [" + std::to_string(min_) + ", " + std::to_string(max_) +
                                "] has its ends the wrong way round");
}

Interval Interval::everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {-inf, inf};
}

}  // namespace offmap::core
