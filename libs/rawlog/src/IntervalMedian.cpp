// SPDX-License-Identifier: BSD-3-Clause
#include "SecondsBetween.h"

#include <offmap/rawlog/IntervalMedian.h>

#include <cmath>

namespace offmap::rawlog {

void IntervalMedian::add(mrpt::Clock::time_point time) {
    if (latest_ && time > *latest_) {
        const double interval = secondsBetween(*latest_, time);
        Bin& bin = bins_[static_cast<int>(std::floor(std::log(interval) / std::log(1.01)))];
        ++bin.count;
        bin.sum += interval;
        ++count_;
    }
    latest_ = time;
}

std::optional<double> IntervalMedian::seconds() const {
    uint64_t below = 0;
    for (const auto& [logarithm, bin] : bins_) {
        below += bin.count;
        if (2 * below >= count_) return bin.sum / static_cast<double>(bin.count);
    }
    return std::nullopt;
}

std::optional<double> IntervalMedian::rate() const {
    const auto interval = seconds();
    return interval ? std::optional(1 / *interval) : std::nullopt;
}

}  // namespace offmap::rawlog
