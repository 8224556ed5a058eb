// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/CloudPoints.h>
#include <offmap/rawlog/ColumnBuilder.h>

#include <mrpt/poses/CPose3D.h>

#include <span>

namespace offmap::rawlog {

/// The upward direction of the vehicle in a sensor's axes.
struct Upwards {
    explicit Upwards(const mrpt::poses::CPose3D& sensorInVehicle) {
        const auto& rotation = sensorInVehicle.getRotationMatrix();
        direction = {rotation(2, 0), rotation(2, 1), rotation(2, 2)};
    }
    mrpt::math::TPoint3D direction;
};

/// How the returns of a column follow each other.
enum class ElevationOrder { Upward, Downward, Mixed };

/// Upward or downward only if each return is clearly above the one before, or below it, so that
/// rounding cannot make it look otherwise. Told quickly. \pre there is one; all are finite
ElevationOrder elevationOrderOf(const CloudPoints& returns, const Upwards& up);
ElevationOrder elevationOrderOf(std::span<const mrpt::math::TPoint3Df> returns, const Upwards& up);

/// Sorts the returns of a column by elevation, those at one elevation by range.
void sortUpward(std::span<ColumnReturn> returns, const Upwards& up);

}  // namespace offmap::rawlog
