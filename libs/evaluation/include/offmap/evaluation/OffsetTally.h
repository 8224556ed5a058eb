// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace offmap::evaluation {

/// Weighted mean and spread of what was tallied.
struct Spread {
    double weight = 0, sum = 0, squares = 0;  ///< of the weights, weighted values and their squares
    uint64_t segments = 0, returns = 0;

    void add(double value, double by, uint32_t returnsOfIt);
    void add(const Spread& other);
    double mean() const { return sum / weight; }
    double deviation() const;  ///< standard deviation
};

/// Offsets of segments from a wall, in memory that does not grow with their number.
class OffsetTally {
 public:
    /// \param gate [m] offsets are within, to either side
    explicit OffsetTally(double gate) : gate_(gate) {}

    /// \param offset [m] \param weight > 0; without effect beyond the gate
    void add(double offset, double weight, uint32_t returns);

    /// Of the offsets about the place where most of the weight is: what stands before the surface
    /// or is seen through it does not count. \param width [m] in which they are
    Spread densest(double width) const;

 private:
    double gate_;                // [m]
    std::vector<Spread> cells_;  // from -gate on; empty until something is tallied
};

}  // namespace offmap::evaluation
