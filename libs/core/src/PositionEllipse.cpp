// SPDX-License-Identifier: BSD-3-Clause
#include "RootOfSquares.h"

#include <offmap/core/PositionEllipse.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

PositionEllipse::PositionEllipse(const Eigen::Matrix2d& covariance) {
    const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
    const double difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
    const double spread = rootOfSquares(difference, covariance(0, 1));
    a_ = std::sqrt(std::max(mean + spread, 0.0));
    b_ = std::sqrt(std::max(mean - spread, 0.0));
    // At half the angle of (difference, covariance), from the larger component.
    const double larger = spread + std::abs(difference), smaller = covariance(0, 1);
    const double norm = rootOfSquares(larger, smaller);
    if (!(norm > 0)) return;  // a circle: any axis is
    majorAxis_ = difference >= 0 ? mrpt::math::TPoint2D(larger, smaller) * (1 / norm)
                                 : mrpt::math::TPoint2D(smaller, larger) * (1 / norm);
}

double PositionEllipse::squaredRadius(const mrpt::math::TPoint2D& direction) const {
    const double cosKappa = direction.x * majorAxis_.x + direction.y * majorAxis_.y;
    const double sinKappa = direction.x * majorAxis_.y - direction.y * majorAxis_.x;
    // Eq. 6 multiplied out, which also serves a circle of no size and an ellipse of no width.
    const double acrossMajor = a_ * sinKappa, acrossMinor = b_ * cosKappa;
    const double denominator = acrossMajor * acrossMajor + acrossMinor * acrossMinor;
    if (denominator > 0) return a_ * a_ * (b_ * b_) / denominator;
    return a_ * a_;  // along an ellipse of no width, or a_ == 0
}

}  // namespace offmap::core
