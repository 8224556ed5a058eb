// SPDX-License-Identifier: BSD-3-Clause
#include "NearestColumn.h"

#include "WrappedAngle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace offmap::rawlog {

uint32_t NearestColumn::search(double azimuth) const {
    const auto above = std::lower_bound(sorted_.begin(), sorted_.end(), azimuth);
    const auto next = above == sorted_.end() ? sorted_.begin() : above;
    const auto previous = above == sorted_.begin() ? std::prev(sorted_.end()) : std::prev(above);
    const auto away = [&](auto column) { return std::abs(wrapped(*column - azimuth)); };
    const auto nearest = away(next) < away(previous) ? next : previous;
    return static_cast<uint32_t>(std::distance(sorted_.begin(), nearest));
}

double NearestColumn::reach(uint32_t column) const {
    constexpr double rounding = 1e-9;  // [rad]
    constexpr double fullTurn = 2.0 * std::numbers::pi;
    const size_t last = sorted_.size() - 1;
    const double before = column == 0 ? sorted_[last] - fullTurn : sorted_[column - 1];
    const double behind = column == last ? sorted_[0] + fullTurn : sorted_[column + 1];
    return 0.5 * std::min(sorted_[column] - before, behind - sorted_[column]) - rounding;
}

uint32_t NearestColumn::of(double azimuth) {
    const auto count = static_cast<uint32_t>(sorted_.size());
    for (const uint32_t column : {last_, (last_ + 1) % count, (last_ + count - 1) % count}) {
        if (std::abs(azimuth - sorted_[column]) < reach(column)) return last_ = column;
    }
    return last_ = search(azimuth);
}

}  // namespace offmap::rawlog
