// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/SweepFan.h>

#include <mrpt/core/bits_math.h>

#include <cmath>

namespace offmap::rawlog {

using mrpt::math::TPoint2D;
using mrpt::obs::CObservation2DRangeScan;

bool isVerticalFan(const CObservation2DRangeScan& scan) {
    // A fan that pitches while it is taken is not a plane.
    if (scan.deltaPitch != 0) return false;
    const double normalZ = scan.sensorPose.getRotationMatrix()(2, 2);
    return std::abs(normalZ) <= std::sin(mrpt::DEG2RAD(15.0));
}

FanAxis chooseFanAxis(const CObservation2DRangeScan& scan) {
    const double xAxisZ = scan.sensorPose.getRotationMatrix()(2, 0);
    return std::abs(xAxisZ) <= std::cos(mrpt::DEG2RAD(15.0)) ? FanAxis::X : FanAxis::Y;
}

TPoint2D fanDirection(const CObservation2DRangeScan& scan, FanAxis axis) {
    const auto& rotation = scan.sensorPose.getRotationMatrix();
    // The normal's horizontal part, turned by 90 degrees.
    const TPoint2D along(rotation(1, 2), -rotation(0, 2));
    const int column = axis == FanAxis::X ? 0 : 1;
    const double towardsAxis = along.x * rotation(0, column) + along.y * rotation(1, column);
    return along * ((towardsAxis < 0 ? -1.0 : 1.0) / along.norm());
}

double fanAzimuth(const CObservation2DRangeScan& scan, FanAxis axis) {
    const TPoint2D direction = fanDirection(scan, axis);
    return std::atan2(direction.y, direction.x);
}

double beamAngle(const CObservation2DRangeScan& scan, size_t i) {
    const size_t beams = scan.getScanSize();
    if (beams < 2) return 0;
    const double share = static_cast<double>(i) / static_cast<double>(beams - 1) - 0.5;
    return static_cast<double>(scan.aperture) * (scan.rightToLeft ? share : -share);
}

const std::vector<TPoint2D>& BeamDirections::of(const CObservation2DRangeScan& scan) {
    const size_t beams = scan.getScanSize();
    if (directions_.size() == beams && aperture_ == scan.aperture &&
        rightToLeft_ == scan.rightToLeft) {
        return directions_;
    }
    directions_.clear();
    for (size_t i = 0; i < beams; ++i) {
        const double angle = beamAngle(scan, i);
        directions_.emplace_back(std::cos(angle), std::sin(angle));
    }
    aperture_ = scan.aperture;
    rightToLeft_ = scan.rightToLeft;
    return directions_;
}

}  // namespace offmap::rawlog
