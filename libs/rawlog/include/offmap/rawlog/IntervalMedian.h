// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <cstdint>
#include <map>
#include <optional>

namespace offmap::rawlog {

/// The median interval between time stamps as they come, in memory that does not grow with their
/// number. Stamps that stand still or run back make no interval.
class IntervalMedian {
 public:
    void add(mrpt::Clock::time_point time);

    /// [s] the mean of those intervals that lie within 1 % of the median; none before two stamps.
    std::optional<double> seconds() const;
    /// [Hz]
    std::optional<double> rate() const;

 private:
    struct Bin {
        uint64_t count = 0;
        double sum = 0;  ///< [s]
    };
    std::map<int, Bin> bins_;  ///< by the interval's logarithm, in steps of 1 %
    uint64_t count_ = 0;
    std::optional<mrpt::Clock::time_point> latest_;
};

}  // namespace offmap::rawlog
