// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPath.h"

#include <cmath>

namespace offmap::window {

namespace {

/// [m] From one frame shown to the next: 1 m/s a hundred times as fast, 30 frames a second, are 3.3
/// m.
constexpr double longestStep = 5;

}  // namespace

void PlanPath::add(const mrpt::math::TPoint2D& place, mrpt::Clock::time_point time) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return;
    const bool begins =
        places_.empty() || time < latestTime_ || (place - latest_).norm() > longestStep;
    latestTime_ = time;
    latest_ = place;
    if (!begins && (place - places_.back().place).norm() < leastStep_) return;
    places_.push_back({place, begins});
    if (places_.size() > mostPlaces) thinOut();
}

void PlanPath::clear() { *this = {}; }

void PlanPath::thinOut() {
    leastStep_ *= 2;
    std::vector<Place> kept;
    for (const Place& next : places_) {
        if (next.begins || (next.place - kept.back().place).norm() >= leastStep_) {
            kept.push_back(next);
        }
    }
    // A path of nothing but breaks: its older half is forgotten.
    if (kept.size() > mostPlaces) {
        kept.erase(kept.begin(), kept.begin() + mostPlaces / 2);
        kept.front().begins = true;
    }
    places_ = std::move(kept);
}

}  // namespace offmap::window
