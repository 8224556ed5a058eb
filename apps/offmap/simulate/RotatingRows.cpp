// SPDX-License-Identifier: BSD-3-Clause
#include "RotatingRows.h"

#include <offmap/rawlog/LidarModels.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace offmap::app {

namespace {

constexpr const char* vlp16Model = "VLP-16";

/// [rad] What the elevations of a model may be off: its calibration is told to 0.01 degrees.
constexpr double tolerance = 1e-3;

/// Whether its rings are those of a VLP-16.
bool isVlp16(const evaluation::Scanner& scanner) {
    auto known = rawlog::elevationsOfModel(vlp16Model);
    std::ranges::sort(known);
    return std::ranges::equal(known, scanner.elevations,
                              [](double a, double b) { return std::abs(a - b) < tolerance; });
}

}  // namespace

std::string rotatingModel(const evaluation::Scanner& scanner) {
    return isVlp16(scanner) ? vlp16Model : "SIMULATED";
}

std::vector<size_t> ringsOfRows(const evaluation::Scanner& scanner) {
    std::vector<size_t> rings(scanner.elevations.size());
    std::iota(rings.begin(), rings.end(), size_t{0});
    if (!isVlp16(scanner)) return rings;
    const auto known = rawlog::elevationsOfModel(vlp16Model);
    for (size_t row = 0; row < known.size(); ++row) {
        rings[row] = static_cast<size_t>(
            std::ranges::count_if(known, [&](double elevation) { return elevation < known[row]; }));
    }
    return rings;
}

}  // namespace offmap::app
