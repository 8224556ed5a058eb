// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PoseCorrection.h>

namespace offmap::core {

/// What the sights of one wall tell of the pose. They share the error of the map: each end of the
/// wall stands off the truth by its sigma, independently of the other, and takes the line between
/// along. Sights of one wall are therefore not independent measurements; the two errors are
/// marginalised out (Schur complement), which is what keeps the posterior covariance honest.
class WallInformation {
 public:
    /// One measurement of how far a point seen stands off the wall.
    /// \param gradient of that distance by the pose \param share [0, 1] of the way from the wall's
    /// first end to its second \param distance [m] \param weight [1/m^2]
    void add(const Vector5& gradient, double share, double distance, double weight);

    /// Adds this wall's part to the normal equations. \param sigma [m] of the wall, > 0
    void marginalise(double sigma, Matrix5& information, Vector5& slope) const;

 private:
    using Vector8 = Eigen::Matrix<double, 8, 1>;
    using Matrix8 = Eigen::Matrix<double, 8, 8>;

    Matrix8 squares_ = Matrix8::Zero();  // sum w v v^T, v: gradient, share of each end, distance;
                                         // the lower triangle
};

}  // namespace offmap::core
