// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Direction.h>
#include <offmap/rawlog/VelodyneModel.h>

#include <optional>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// Where a Velodyne's lasers look, as the head turns while it fires one after the other: clockwise,
/// from where a block of returns begins.
class LaserDirections {
 public:
    /// \param azimuthCorrections [rad] CCW, per laser; empty: all look where the head does
    LaserDirections(const VelodyneModel& model, size_t lasers,
                    const std::vector<double>& azimuthCorrections)
        : model_(model), lasers_(lasers), azimuthCorrections_(azimuthCorrections) {}

    /// Of one packet, most often of a whole scan. \param rate [1/100 deg / us] of the head
    void setRate(double rate);

    /// [1/100 deg] that the head turns until it fires the l-th laser of a block's firing.
    double turned(size_t firing, double l) const {
        return *rate_ *
               (static_cast<double>(firing) * model_.firingPeriod + l * model_.laserPeriod);
    }
    /// Per laser. \pre the rate is set
    std::span<const Direction> ofFiring(size_t firing) const {
        return std::span(directions_).subspan(firing * lasers_, lasers_);
    }

 private:
    const VelodyneModel& model_;
    size_t lasers_;
    const std::vector<double>& azimuthCorrections_;
    std::optional<double> rate_;
    std::vector<Direction> directions_;  // firing after firing
};

}  // namespace offmap::rawlog
