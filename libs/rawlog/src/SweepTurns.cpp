// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SweepTurns.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace offmap::rawlog {

using mrpt::obs::CObservation2DRangeScan;

namespace {

constexpr double clearTurn = mrpt::DEG2RAD(1.0);
/// [rad] Noise of an encoder. A larger share of a step would cut off the last columns of a turn
/// that falls short of a full one by less than its step.
constexpr double wrapTolerance = mrpt::DEG2RAD(0.1);
constexpr uint32_t mostColumns = 100'000;

}  // namespace

bool SweepTurns::startsNewTurn(const CObservation2DRangeScan& scan) {
    wrapped_ = false;
    if (state_) {
        const uint32_t columnsBefore = state_->columns;
        const auto timeBefore = state_->time;
        advance(scan);
        const bool endedOtherwise = ended(scan, columnsBefore, timeBefore);
        wrapped_ = !endedOtherwise && goneRound();
        if (!wrapped_ && !endedOtherwise) return false;
    }
    const FanAxis axis = chooseFanAxis(scan);
    state_ = State{.axis = axis, .azimuth = fanAzimuth(scan, axis), .time = scan.timestamp};
    return true;
}

void SweepTurns::advance(const CObservation2DRangeScan& scan) {
    const double azimuth = fanAzimuth(scan, state_->axis);
    state_->swept += mrpt::math::wrapToPi(azimuth - state_->azimuth);
    state_->minSwept = std::min(state_->minSwept, state_->swept);
    state_->maxSwept = std::max(state_->maxSwept, state_->swept);
    state_->azimuth = azimuth;
    state_->time = scan.timestamp;
    ++state_->columns;
}

bool SweepTurns::goneRound() const {
    return std::abs(state_->swept) >= 2.0 * std::numbers::pi - wrapTolerance;
}

/// For another reason than the azimuth's wrap.
bool SweepTurns::ended(const CObservation2DRangeScan& scan, uint32_t columnsBefore,
                       mrpt::Clock::time_point timeBefore) const {
    const uint32_t limit = config_.columnsPerTurn > 0 ? config_.columnsPerTurn : mostColumns;
    if (columnsBefore >= limit) return true;

    const double pause = std::chrono::duration<double>(scan.timestamp - timeBefore).count();
    if (std::abs(pause) > config_.maxColumnPause) return true;

    const bool counterClockwise = state_->maxSwept >= -state_->minSwept;
    const double turnedBack =
        counterClockwise ? state_->maxSwept - state_->swept : state_->swept - state_->minSwept;
    return turnedBack > clearTurn;
}

void SweepDetector::see(const CObservation2DRangeScan& scan) {
    if (!isVerticalFan(scan)) {
        allVertical_ = false;
        return;
    }
    if (!axis_) {
        axis_ = chooseFanAxis(scan);
        firstAzimuth_ = fanAzimuth(scan, *axis_);
    }
    const double turned = mrpt::math::wrapToPi(fanAzimuth(scan, *axis_) - firstAzimuth_);
    if (std::abs(turned) > clearTurn) turns_ = true;
}

}  // namespace offmap::rawlog
