// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

#include <vector>

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

/// Appends the places of those columns that have none yet; of one without a pose, none that means
/// anything.
void addPlaces(const OrganizedScan& scan, std::vector<ColumnPlace>& places);

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

/// Cosine and sine of a correction's turn, which all columns have in common.
struct Turn {
    explicit Turn(const PoseCorrection& correction);
    double cosine, sine;
};

/// How far behind a straight line stands what a column sees.
struct LinearDistance {
    double ofSensor;                 ///< [m]
    mrpt::math::TPoint2D perGround;  ///< [-]
    double perHeight;                ///< [-]

    double of(const SeenPoint& point) const {
        return ofSensor + perGround.x * point.ground.x + perGround.y * point.ground.y +
               perHeight * point.z;
    }
};

/// One column under a correction: as PoseCorrection::apply(), for many points.
class CorrectedColumn {
 public:
    CorrectedColumn(const PoseCorrection& correction, const ColumnPlace& column)
        : CorrectedColumn(correction, Turn(correction), column) {}
    CorrectedColumn(const PoseCorrection& correction, const Turn& turn, const ColumnPlace& column);

    /// Place in the map [m] of what the column sees, to first order in the lean.
    mrpt::math::TPoint2D place(const SeenPoint& point) const {
        return sensor_ + turned(point.ground) + leanPerHeight_ * point.z;
    }

    /// [m] Above the sensor, with the lean undone.
    double height(const SeenPoint& point) const {
        return point.z + point.ground.x * risePerGround_.x + point.ground.y * risePerGround_.y;
    }

    /// Derivative of place() across a wall with the given unit normal.
    Vector5 gradient(const SeenPoint& point, const mrpt::math::TPoint2D& normal) const;

    /// Of what is seen, from a line through a place in the map. \param normal unit vector
    LinearDistance distanceBehind(const mrpt::math::TPoint2D& through,
                                  const mrpt::math::TPoint2D& normal) const;

 private:
    mrpt::math::TPoint2D turned(const mrpt::math::TPoint2D& p) const {
        return {cosine_ * p.x - sine_ * p.y, sine_ * p.x + cosine_ * p.y};
    }

    double cosine_, sine_;                      // of the turn
    mrpt::math::TPoint2D centre_;               // [m] the pivot, shifted
    mrpt::math::TPoint2D sensor_;               // [m] in the map
    mrpt::math::TPoint2D perLeanX_, perLeanY_;  // [1/rad] shift on the ground per height
    mrpt::math::TPoint2D leanPerHeight_;        // [-]
    mrpt::math::TPoint2D risePerGround_;        // [-] before the turn
};

}  // namespace offmap::core
