// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LidarModels.h>
#include <offmap/rawlog/RotatingGeometry.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <chrono>
#include <cmath>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationRotatingScan;

/// [rad] No Velodyne fires that often: at 5 turns/s an HDL-32E turns 0.083 degrees from one firing
/// to the next. Of MRPT's columns there are 16 or 32 to a firing, which at 20 turns/s make 0.025.
const double narrowestFiring = mrpt::DEG2RAD(0.05);

bool emptyFrom(const mrpt::math::CMatrix_u16& image, uint32_t column) {
    for (int r = 0; r < image.rows(); ++r) {
        for (auto c = static_cast<int>(column); c < image.cols(); ++c) {
            if (image(r, c) != 0) return false;
        }
    }
    return true;
}

/// Of a scan that MRPT made of Velodyne packets: how many columns it used. 0 of any other.
uint32_t columnsOfConversion(const Scan& obs) {
    constexpr uint32_t returnsPerPacket = mrpt::obs::CObservationVelodyneScan::SCANS_PER_PACKET;
    const bool asWide = isVelodyneModel(obs.lidarModel) && obs.columnCount >= returnsPerPacket &&
                        obs.columnCount % returnsPerPacket == 0 &&
                        std::abs(obs.azimuthSpan) < narrowestFiring * obs.columnCount;
    if (!asWide || obs.rowCount != elevationsOfModel(obs.lidarModel).size()) return 0;
    const uint32_t used = obs.columnCount / obs.rowCount / (obs.rangeOtherLayers.empty() ? 1 : 2);
    bool empty = emptyFrom(obs.rangeImage, used);
    for (const auto& [name, layer] : obs.rangeOtherLayers) {
        empty = empty && emptyFrom(layer, used);
    }
    return empty ? used : 0;
}

bool isClockwise(const Scan& obs, AzimuthSense sense) {
    switch (sense) {
        case AzimuthSense::Clockwise:
            return true;
        case AzimuthSense::CounterClockwise:
            return false;
        case AzimuthSense::Auto:
            break;
    }
    // A Velodyne turns clockwise: a negative span, were it counted as documented.
    return isVelodyneModel(obs.lidarModel) && obs.azimuthSpan > 0;
}

/// [s] from the scan's first column to what its time stamp tells.
double stampAfterStart(const Scan& obs, TimeReference reference) {
    switch (reference) {
        case TimeReference::First:
            return 0;
        case TimeReference::Middle:
            return 0.5 * obs.sweepDuration;
        case TimeReference::Last:
            break;
    }
    return obs.sweepDuration;
}

mrpt::Clock::duration seconds(double s) {
    return std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(s));
}

}  // namespace

RotatingGeometry::RotatingGeometry(const Scan& obs, const SensorConfig& config)
    : rangeResolution_(obs.rangeResolution),
      startTime_(obs.timestamp - seconds(stampAfterStart(obs, config.timeReference))) {
    constexpr uint32_t returnsPerBlock = mrpt::obs::CObservationVelodyneScan::SCANS_PER_BLOCK;
    const uint32_t converted = columnsOfConversion(obs);
    columns_ = converted ? converted : obs.columnCount;
    columnsPerFiring_ = converted ? returnsPerBlock / obs.rowCount : 1;
    const uint32_t stepsInSpan = converted ? converted : columns_ - 1U;
    const double sign = isClockwise(obs, config.azimuthSense) ? -1 : 1;
    startAzimuth_ = sign * obs.startAzimuth;
    azimuthStep_ = stepsInSpan ? sign * obs.azimuthSpan / stepsInSpan : 0;
    timeStep_ = stepsInSpan ? obs.sweepDuration / stepsInSpan : 0;
    const auto ofModel = elevationsOfModel(obs.lidarModel);
    for (const double elevation : config.elevations.empty() ? ofModel : config.elevations) {
        elevations_.push_back(Direction::of(elevation));
    }
    for (uint32_t c = 0; c < columns_; ++c) azimuths_.push_back(Direction::of(azimuth(c)));
}

double RotatingGeometry::azimuth(uint32_t column) const {
    return startAzimuth_ + azimuthStep_ * steps(column);
}

mrpt::Clock::time_point RotatingGeometry::time(uint32_t column) const {
    return startTime_ + seconds(timeStep_ * steps(column));
}

mrpt::math::TPoint3Df RotatingGeometry::point(uint32_t row, uint32_t column, uint16_t value) const {
    const Direction up = elevations_.at(row), around = azimuths_.at(column);
    const double range = rangeResolution_ * value;
    const double ground = range * up.cos;
    return {static_cast<float>(ground * around.cos), static_cast<float>(ground * around.sin),
            static_cast<float>(range * up.sin)};
}

}  // namespace offmap::rawlog
