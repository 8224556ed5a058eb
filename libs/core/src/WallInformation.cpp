// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallInformation.h>

#include <Eigen/LU>

namespace offmap::core {

void WallInformation::add(const Vector5& gradient, double share, double distance, double weight) {
    const Eigen::Vector2d ends(1 - share, share);
    const Vector5 weighted = weight * gradient;
    pose_ += weighted * gradient.transpose();
    poseSlope_ += distance * weighted;
    poseAndEnds_ += weighted * ends.transpose();
    ends_ += weight * ends * ends.transpose();
    endsSlope_ += weight * distance * ends;
}

void WallInformation::marginalise(double sigma, Matrix5& information, Vector5& slope) const {
    const Eigen::Matrix2d ends = ends_ + Eigen::Matrix2d::Identity() / (sigma * sigma);
    const Matrix52 gain = poseAndEnds_ * ends.inverse();
    information += pose_ - gain * poseAndEnds_.transpose();
    slope += poseSlope_ - gain * endsSlope_;
}

}  // namespace offmap::core
