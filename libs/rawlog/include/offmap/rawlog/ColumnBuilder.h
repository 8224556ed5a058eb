// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/CloudPoints.h>
#include <offmap/rawlog/PoseSource.h>
#include <offmap/rawlog/ScanClass.h>

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// A return on its way into a column.
struct ColumnReturn {
    mrpt::math::TPoint3Df point;  ///< [m] in the frame of its column's sensor
    uint32_t slot = 0;            ///< in the turn
    /// [-] Square of the elevation's sine, with its sign, in the vehicle's axes; filled in where
    /// it is needed.
    double squaredSine = 0;
};

/// Whether a point is finite and not the origin, told quickly of most; of one without branches, so
/// that many can be told together.
inline bool isClearlyReturn(float x, float y, float z) {
    const float size = std::abs(x) + std::abs(y) + std::abs(z);
    return (0 < size) & (size <= std::numeric_limits<float>::max());
}

/// Counts what stands in a slot. \return true if it is a return: finite and not the origin
inline bool countReturn(ReturnCounts& counts, const mrpt::math::TPoint3Df& point) {
    if (isClearlyReturn(point.x, point.y, point.z)) {
        ++counts.returns;
        return true;
    }
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
        ++counts.nonFinite;
        return false;
    }
    if (point.x == 0 && point.y == 0 && point.z == 0) {
        ++counts.zero;
        return false;
    }
    ++counts.returns;
    return true;
}

/// The slots of points that stand one behind the other: numbered on, or listed.
struct PointSlots {
    uint32_t first = 0;                ///< the slot of point 0, if they are numbered on
    std::span<const uint32_t> listed;  ///< one a point; empty if they are numbered on

    uint32_t operator[](uint32_t i) const { return listed.empty() ? first + i : listed[i]; }
};

/// Gives a column its mounting and, where the vehicle has a pose, the pose of its sensor.
void placeColumn(core::ScanColumn& column, const PoseLookup& vehicle,
                 const mrpt::poses::CPose3D& sensorInVehicle);

/// Azimuth in the vehicle's axes of a direction in the sensor's horizontal plane [rad].
double azimuthInVehicle(double azimuthInSensor, const mrpt::poses::CPose3D& sensorInVehicle);

/// Gives the last column the last returns, from `begin` on: bottom to top by elevation in the
/// vehicle's axes, exact duplicates taken out and counted. The order is total, so that in which
/// they were added does not matter.
void closeColumn(TurnScan& out, const mrpt::poses::CPose3D& sensorInVehicle, size_t begin);

/// Adds a column with its returns.
void appendColumn(TurnScan& out, const core::ScanColumn& column,
                  const mrpt::poses::CPose3D& sensorInVehicle,
                  std::span<const ColumnReturn> returns);

/// The same with points `begin` to `end` of a cloud, where they already stand so, or from top to
/// bottom. \return false, and nothing is done, if they do not
bool appendColumnInOrder(TurnScan& out, const core::ScanColumn& column,
                         const mrpt::poses::CPose3D& sensorInVehicle, const CloudPoints& points,
                         const PointSlots& slots, uint32_t begin, uint32_t end);

}  // namespace offmap::rawlog
