// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"

#include <algorithm>
#include <cmath>

namespace offmap::app {

PointsByBeam::PointsByBeam(const evaluation::SimulatedScan& scan,
                           const evaluation::Scanner& scanner)
    : rings_(scanner.elevations.size()), points_(scanner.azimuths.size() * rings_) {
    for (uint32_t i = 0; i < scan.scan.points.size(); ++i) {
        points_.at(scan.scan.sourceIndex[i]) = i;
    }
}

std::optional<uint32_t> PointsByBeam::at(size_t column, size_t ring) const {
    return points_[column * rings_ + ring];
}

double rangeOf(const evaluation::SimulatedScan& scan, uint32_t point) {
    const auto& p = scan.scan.points[point];
    return std::hypot(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
}

float intensityOf(const evaluation::SimulatedScan& scan, uint32_t point) {
    return scan.truth[point].intensity;
}

uint8_t eightBits(float share) {
    return static_cast<uint8_t>(
        std::lround(255 * std::clamp(static_cast<double>(share), 0.0, 1.0)));
}

}  // namespace offmap::app
