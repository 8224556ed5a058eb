// SPDX-License-Identifier: BSD-3-Clause
#include "LaserDirections.h"

#include "VelodyneFields.h"

namespace offmap::rawlog {

void LaserDirections::setRate(double rate) {
    if (rate == rate_) return;
    rate_ = rate;
    directions_.clear();
    constexpr size_t lasersPerBlock = mrpt::obs::CObservationVelodyneScan::SCANS_PER_BLOCK;
    for (size_t firing = 0; firing < model_.firingsPerBlock; ++firing) {
        for (size_t laser = 0; laser < lasers_; ++laser) {
            double azimuth = toRadians(turned(firing, static_cast<double>(laser % lasersPerBlock)));
            if (!azimuthCorrections_.empty()) azimuth -= azimuthCorrections_[laser];
            directions_.push_back(Direction::of(azimuth));
        }
    }
}

}  // namespace offmap::rawlog
