// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

namespace offmap::core {

/// What the poses of a scan may be wrong by, all columns alike: a shift dx, dy [m], a turn of the
/// heading [rad] about a pivot, and a lean of the sensor about the vehicle's x and y axes [rad].
using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/// A return's place, or that of a point of a fitted line, as its column sees it.
struct SeenPoint {
    mrpt::math::TPoint2D ground;  ///< [m] from the sensor, along the axes of the map
    double z;                     ///< [m] above the sensor
};

/// Where one column was taken, as far as corrections have to know.
struct ColumnPlace {
    mrpt::math::TPoint2D position;      ///< [m] of the sensor, in the map
    mrpt::math::TPoint2D vehicleAlong;  ///< unit vector of the vehicle's heading, in the map
};

/// \pre the column has a pose
ColumnPlace placeOf(const ScanColumn& column);

/// A correction of a scan's poses and how far it may be wrong itself.
struct PoseCorrection {
    mrpt::math::TPoint2D pivot;            ///< [m] in the map: the turn's fixed point
    Vector5 mean = Vector5::Zero();        ///< see Vector5
    Matrix5 covariance = Matrix5::Zero();  ///< of the mean

    /// Place in the map [m] of what a column sees, to first order in the lean.
    mrpt::math::TPoint2D apply(const ColumnPlace& column, const SeenPoint& point) const;

    /// Derivative of apply() across a wall with the given unit normal.
    Vector5 gradient(const ColumnPlace& column, const SeenPoint& point,
                     const mrpt::math::TPoint2D& normal) const;
};

}  // namespace offmap::core
