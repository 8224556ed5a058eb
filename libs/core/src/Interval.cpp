// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Interval.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace offmap::core {

Interval::Interval(double min, double max) : min_(min), max_(max) {
    if (!(min <= max)) {
        throw std::invalid_argument("interval [" + std::to_string(min) + ", " +
                                    std::to_string(max) + "] has its ends the wrong way round");
    }
}

Interval Interval::everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {-inf, inf};
}

}  // namespace offmap::core
