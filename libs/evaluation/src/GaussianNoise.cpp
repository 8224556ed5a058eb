// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/GaussianNoise.h>

#include <cmath>
#include <numbers>

namespace offmap::evaluation {

double GaussianNoise::uniform() {
    // the 53 bits that a double holds
    return static_cast<double>((generator_() >> 11) + 1) * 0x1p-53;
}

double GaussianNoise::next(double sigma) {
    if (spare_) {
        const double number = *spare_;
        spare_.reset();
        return sigma * number;
    }
    const double radius = std::sqrt(-2 * std::log(uniform()));
    const double angle = 2 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    return sigma * radius * std::cos(angle);
}

}  // namespace offmap::evaluation
