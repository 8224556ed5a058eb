// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/UniformNumbers.h>

#include <algorithm>
#include <stdexcept>

namespace offmap::evaluation {

double UniformNumbers::between(double low, double high) {
    // the 53 bits that a double holds
    const double share = static_cast<double>(generator_() >> 11) * 0x1p-53;
    return low + share * (high - low);
}

size_t UniformNumbers::below(size_t count) {
    if (count == 0) throw std::invalid_argument("a choice from nothing");
    // rounding can reach the upper end of a very large count
    return std::min(static_cast<size_t>(between(0, static_cast<double>(count))), count - 1);
}

}  // namespace offmap::evaluation
