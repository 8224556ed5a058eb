// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/SensorConfig.h>
#include <offmap/rawlog/SweepFan.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <optional>

namespace offmap::rawlog {

/// Divides the vertical fans of one label into turns, one after the other as they come. A turn ends
/// - where the azimuth has gone round once, in either direction, to 0.1 degrees;
/// - after SensorConfig::columnsPerTurn columns (without it, after 100,000: one that stands still);
/// - where the time stamps of two columns are more than maxColumnPause apart, also backwards;
/// - where the fan has turned back by more than 1 degree. Those first columns of the way back, up
///   to 1 degree, still belong to the turn that ends.
class SweepTurns {
 public:
    explicit SweepTurns(const SensorConfig& config) : config_(config) {}

    /// Whether this scan is the first column of a new turn, as the very first scan is. Remembers
    /// the scan; each one has to be given once, in the order of the log.
    bool startsNewTurn(const mrpt::obs::CObservation2DRangeScan& scan);

    /// Whether the latest turn began because the azimuth had gone round, not for any other reason.
    bool wrapped() const { return wrapped_; }

    /// As if no scan had been seen.
    void reset() { state_.reset(); }

 private:
    struct State {
        FanAxis axis;
        double azimuth;                ///< [rad] of the latest column
        mrpt::Clock::time_point time;  ///< of the latest column
        double swept = 0;              ///< [rad] since the turn's first column, CCW positive
        double minSwept = 0, maxSwept = 0;
        uint32_t columns = 1;
    };

    void advance(const mrpt::obs::CObservation2DRangeScan& scan);
    bool ended(const mrpt::obs::CObservation2DRangeScan& scan, uint32_t columnsBefore,
               mrpt::Clock::time_point timeBefore) const;

    bool goneRound() const;

    SensorConfig config_;
    std::optional<State> state_;
    bool wrapped_ = false;
};

/// Tells from all scans of a label whether it is a sweep.
class SweepDetector {
 public:
    void see(const mrpt::obs::CObservation2DRangeScan& scan);

    /// All scans seen are vertical fans, and their azimuth changes by more than 1 degree.
    bool isSweep() const { return allVertical_ && turns_; }

 private:
    bool allVertical_ = true;
    bool turns_ = false;
    std::optional<FanAxis> axis_;
    double firstAzimuth_ = 0;  ///< [rad]
};

}  // namespace offmap::rawlog
