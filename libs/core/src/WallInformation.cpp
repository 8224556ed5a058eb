// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/core/WallInformation.h>

#include <Eigen/LU>

namespace offmap::core {

namespace {

/// squares += weight v v^T of 8 x 8. Four rows at a time, so a little more than the lower triangle.
OFFMAP_BY_PROCESSOR void addSquares(const double* v, double weight, double* __restrict squares) {
    for (int column = 0; column < 8; ++column) {
        const double weighted = weight * v[column];
        for (int row = column / 4 * 4; row < 8; ++row) {
            squares[8 * column + row] += weighted * v[row];
        }
    }
}

}  // namespace

void WallInformation::add(const Vector5& gradient, double share, double distance, double weight) {
    Vector8 v;
    v << gradient, 1 - share, share, distance;
    addSquares(v.data(), weight, squares_.data());
}

void WallInformation::marginalise(double sigma, Matrix5& information, Vector5& slope) const {
    const Matrix8 squares = squares_.selfadjointView<Eigen::Lower>();
    const Eigen::Matrix2d ends =
        squares.block<2, 2>(5, 5) + Eigen::Matrix2d::Identity() / (sigma * sigma);
    const Eigen::Matrix<double, 5, 2> poseAndEnds = squares.block<5, 2>(0, 5);
    const Eigen::Matrix<double, 5, 2> gain = poseAndEnds * ends.inverse();
    information += squares.topLeftCorner<5, 5>() - gain * poseAndEnds.transpose();
    slope += squares.block<5, 1>(0, 7) - gain * squares.block<2, 1>(5, 7);
}

}  // namespace offmap::core
