// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineFit.h>

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

namespace offmap::evaluation {

/// Total least squares line through weighted points, which are added one by one. Sums are taken
/// from the first point, so that far from the origin nothing is lost.
class WeightedLine {
 public:
    /// \param weight [1/m^2] > 0
    void add(const mrpt::math::TPoint2D& place, double weight);
    /// As if the points of the other had been added one by one.
    void add(const WeightedLine& other);

    /// \pre something was added
    core::FittedLine line() const;
    /// [m] Standard deviation of the points across the line.
    double scatter() const;
    double weight() const { return weight_; }

 private:
    Eigen::Matrix2d covariance() const;  // [m^2] of the points

    mrpt::math::TPoint2D origin_;
    double weight_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

}  // namespace offmap::evaluation
