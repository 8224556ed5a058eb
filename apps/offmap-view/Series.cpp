// SPDX-License-Identifier: BSD-3-Clause
#include "Series.h"

#include <algorithm>
#include <cmath>

namespace offmap::window {

std::deque<Series::Sample>::const_iterator Series::firstFrom(double place) const {
    return std::lower_bound(samples_.begin(), samples_.end(), place,
                            [](const Sample& sample, double p) { return sample.place < p; });
}

void Series::add(double place, double value) {
    if (!std::isfinite(place) || !std::isfinite(value)) return;
    const auto next = firstFrom(place);
    if (next != samples_.end() && next->place == place) {
        samples_[static_cast<size_t>(next - samples_.begin())].value = value;
        return;
    }
    samples_.insert(next, {place, value});
    if (samples_.size() > capacity_) samples_.pop_front();
}

void Series::forgetBefore(double place) { samples_.erase(samples_.begin(), firstFrom(place)); }

std::optional<double> Series::at(double place) const {
    const auto found = firstFrom(place);
    if (found == samples_.end() || found->place != place) return std::nullopt;
    return found->value;
}

std::optional<Series::Sample> Series::last() const {
    if (samples_.empty()) return std::nullopt;
    return samples_.back();
}

std::vector<CurveColumn> Series::columns(double from, double to, size_t count, double gap) const {
    std::vector<CurveColumn> columns;
    if (!(from < to) || count == 0) return columns;
    const double perPlace = static_cast<double>(count) / (to - from);
    double before = from;
    for (auto sample = firstFrom(from); sample != samples_.end() && sample->place < to; ++sample) {
        const auto column =
            std::min(static_cast<size_t>((sample->place - from) * perPlace), count - 1);
        if (!columns.empty() && columns.back().column == column) {
            columns.back().low = std::min(columns.back().low, sample->value);
            columns.back().high = std::max(columns.back().high, sample->value);
        } else {
            const bool joined = !columns.empty() && sample->place - before <= gap;
            columns.push_back({column, sample->value, sample->value, joined});
        }
        before = sample->place;
    }
    return columns;
}

std::optional<double> Series::greatest(double from) const {
    const auto first = firstFrom(from);
    if (first == samples_.end()) return std::nullopt;
    return std::max_element(first, samples_.end(),
                            [](const Sample& a, const Sample& b) { return a.value < b.value; })
        ->value;
}

}  // namespace offmap::window
