// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/OffsetTally.h>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

namespace {

constexpr double cellWidth = 0.01;  // [m] a fifth of what a vertical segment tolerates

}  // namespace

void Spread::add(double value, double by, uint32_t returnsOfIt) {
    weight += by;
    sum += by * value;
    squares += by * value * value;
    ++segments;
    returns += returnsOfIt;
}

void Spread::add(const Spread& other) {
    weight += other.weight;
    sum += other.sum;
    squares += other.squares;
    segments += other.segments;
    returns += other.returns;
}

double Spread::deviation() const {
    return std::sqrt(std::max(0.0, squares / weight - mean() * mean()));
}

void OffsetTally::add(double offset, double weight, uint32_t returns) {
    if (!(std::abs(offset) <= gate_) || !(weight > 0)) return;
    if (cells_.empty()) cells_.resize(static_cast<size_t>(std::ceil(2 * gate_ / cellWidth)) + 1);
    const auto cell = static_cast<size_t>((offset + gate_) / cellWidth);
    cells_[std::min(cell, cells_.size() - 1)].add(offset, weight, returns);
}

Spread OffsetTally::densest(double width) const {
    const size_t window = std::max(size_t{1}, static_cast<size_t>(std::lround(width / cellWidth)));
    Spread best;
    for (size_t first = 0; first < cells_.size(); ++first) {
        Spread within;
        for (size_t i = first; i < std::min(first + window, cells_.size()); ++i) {
            within.add(cells_[i]);
        }
        if (within.weight <= 0) continue;
        // Of equal weights, as of one offset that several windows hold, that about the wall.
        const bool heavier = within.weight > best.weight * (1 + 1e-9);
        const bool asHeavy = within.weight >= best.weight * (1 - 1e-9);
        if (heavier || (asHeavy && std::abs(within.mean()) < std::abs(best.mean()))) best = within;
    }
    return best;
}

}  // namespace offmap::evaluation
