// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace offmap::window {

/// A place on an axis where its value is written.
struct AxisTick {
    double value;
    std::string label;  ///< digits in groups of three, with as many decimals as tell ticks apart
};

/// The least of 1, 2 and 5 times a power of ten that is not less. \pre finite, > 0
double roundUp(double value);
/// The greatest of these that is not more. \pre finite, > 0
double roundDown(double value);

/// The round values from low to high, not more of them than `most`. None if the axis has no length
/// or is not finite. \param whole whether there is nothing between whole numbers
std::vector<AxisTick> axisTicks(double low, double high, size_t most, bool whole = false);

/// A length as on a scale: "2 m", "50 cm", "5 km". \param metres [m]
std::string lengthLabel(double metres);

}  // namespace offmap::window
