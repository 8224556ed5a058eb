// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

#include <cmath>

namespace offmap::core {

/// The one-sigma ellipse of a position on the ground (section 3.2).
class PositionEllipse {
 public:
    PositionEllipse() = default;
    /// \param covariance of x, y [m^2], positive semidefinite
    explicit PositionEllipse(const Eigen::Matrix2d& covariance);

    double semiMajor() const { return a_; }  ///< [m] a
    double semiMinor() const { return b_; }  ///< [m] b

    /// Radius in a direction, b / sqrt(1 - e^2 cos^2 kappa) with e^2 = 1 - b^2 / a^2 [m]; eq. 6,
    /// corrected. \param direction unit vector in the frame of the covariance; kappa is its angle
    /// to the major axis
    double radius(const mrpt::math::TPoint2D& direction) const {
        return std::sqrt(squaredRadius(direction));
    }
    /// [m^2] The variance there.
    double squaredRadius(const mrpt::math::TPoint2D& direction) const;

 private:
    double a_ = 0, b_ = 0;
    mrpt::math::TPoint2D majorAxis_{1, 0};
};

}  // namespace offmap::core
