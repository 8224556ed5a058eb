// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>

namespace offmap::rawlog {

/// Upper triangle of a covariance of x, y [m], yaw [rad]: xx, x-y, x-yaw, yy, y-yaw, yaw-yaw.
using GroundTriangle = std::array<double, 6>;

inline GroundTriangle triangleOf(const Eigen::Matrix3d& c) {
    return {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
}

inline Eigen::Matrix3d matrixOf(const GroundTriangle& c) {
    Eigen::Matrix3d covariance;
    covariance << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
    return covariance;
}

}  // namespace offmap::rawlog
