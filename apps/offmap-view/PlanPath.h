// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <vector>

namespace offmap::window {

/// The way a robot went, as far as a plan shows it: in steps, and coarser the longer it gets.
class PlanPath {
 public:
    struct Place {
        mrpt::math::TPoint2D place;  ///< [m] map frame
        bool begins;                 ///< nothing is known of the way to it from the one before
    };
    static constexpr size_t mostPlaces = 20'000;

    /// The way is broken where the time goes back and where a step is longer than a robot takes.
    void add(const mrpt::math::TPoint2D& place, mrpt::Clock::time_point time);
    void clear();

    const std::vector<Place>& places() const { return places_; }

 private:
    void thinOut();

    std::vector<Place> places_;
    mrpt::math::TPoint2D latest_{0, 0};
    mrpt::Clock::time_point latestTime_{};
    double leastStep_ = 0.05;  // [m] between places
};

}  // namespace offmap::window
