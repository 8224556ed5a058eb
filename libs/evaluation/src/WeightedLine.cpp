// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/WeightedLine.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;

void WeightedLine::add(const mrpt::math::TPoint2D& place, double weight) {
    if (weight_ == 0) origin_ = place;
    const double x = place.x - origin_.x, y = place.y - origin_.y;
    weight_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
    yy_ += weight * y * y;
}

void WeightedLine::add(const WeightedLine& other) {
    if (weight_ == 0) {
        *this = other;
        return;
    }
    const double dx = other.origin_.x - origin_.x, dy = other.origin_.y - origin_.y;
    weight_ += other.weight_;
    xx_ += other.xx_ + dx * (2 * other.x_ + other.weight_ * dx);
    xy_ += other.xy_ + dx * other.y_ + dy * (other.x_ + other.weight_ * dx);
    yy_ += other.yy_ + dy * (2 * other.y_ + other.weight_ * dy);
    x_ += other.x_ + other.weight_ * dx;
    y_ += other.y_ + other.weight_ * dy;
}

Eigen::Matrix2d WeightedLine::covariance() const {
    const double x = x_ / weight_, y = y_ / weight_;
    Eigen::Matrix2d covariance;
    covariance << xx_ / weight_ - x * x, xy_ / weight_ - x * y, 0, yy_ / weight_ - y * y;
    covariance(1, 0) = covariance(0, 1);
    return covariance;
}

core::FittedLine WeightedLine::line() const {
    const Solver solver(covariance());
    const Eigen::Vector2d along = solver.eigenvectors().col(1);  // of the larger eigenvalue
    return {{origin_.x + x_ / weight_, origin_.y + y_ / weight_}, {along.x(), along.y()}};
}

double WeightedLine::scatter() const {
    const Solver solver(covariance(), Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues()(0)));
}

}  // namespace offmap::evaluation
