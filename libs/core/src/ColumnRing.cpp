// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ColumnRing.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offmap::core {

namespace {

double azimuthStep(const ScanColumn& a, const ScanColumn& b) {
    const double step = std::abs(double(b.azimuth) - double(a.azimuth));
    return std::min(step, 2 * std::numbers::pi - step);
}

}  // namespace

ColumnRing::ColumnRing(const OrganizedScan& scan)
    : scan_(scan), size_(static_cast<uint32_t>(scan.columns.size())) {
    if (size_ < 2) return;
    double sum = 0;
    for (uint32_t c = 1; c < size_; ++c) sum += azimuthStep(scan.columns[c - 1], scan.columns[c]);
    constexpr double slack =
        3;  // a dropped column or two, or an uneven motor, is not the end of the turn
    widestStep_ = slack * sum / (size_ - 1);
}

std::optional<uint32_t> ColumnRing::neighbour(uint32_t column, int step) const {
    if (size_ < 2) return std::nullopt;
    const uint32_t next =
        step > 0 ? (column + 1 == size_ ? 0 : column + 1) : (column == 0 ? size_ - 1 : column - 1);
    if (azimuthStep(scan_.columns[column], scan_.columns[next]) > widestStep_) return std::nullopt;
    return next;
}

}  // namespace offmap::core
