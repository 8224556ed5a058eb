// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Scanner.h>

#include <mrpt/core/bits_math.h>

#include <cstddef>
#include <numbers>

namespace offmap::evaluation {

namespace {

/// The azimuths of a clockwise turn, which starts and ends behind the sensor.
std::vector<double> fullTurn(size_t columns) {
    std::vector<double> azimuths(columns);
    for (size_t i = 0; i < columns; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(columns);
        azimuths[i] = std::numbers::pi * (1 - 2 * share);
    }
    return azimuths;
}

/// \param first, last [deg]
std::vector<double> evenlySpaced(double first, double last, size_t count) {
    std::vector<double> elevations(count);
    for (size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        elevations[i] = mrpt::DEG2RAD(first + share * (last - first));
    }
    return elevations;
}

}  // namespace

Scanner paperScanner() { return {fullTurn(181), evenlySpaced(-90, 90, 181), 80, 2.4}; }

Scanner vlp16() { return {fullTurn(1800), evenlySpaced(-15, 15, 16), 100, 0.1}; }

Scanner dense() { return {fullTurn(2048), evenlySpaced(-22.5, 22.5, 128), 120, 0.1}; }

}  // namespace offmap::evaluation
