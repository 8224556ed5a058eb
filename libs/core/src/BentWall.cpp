// SPDX-License-Identifier: BSD-3-Clause
#include "BentWall.h"

#include "RootOfSquares.h"

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

BentWall::BentWall(const Wall& wall)
    : middle_((wall.line.point1 + wall.line.point2) * 0.5),
      along_(wall.line.point2 - wall.line.point1),
      curvature_(wall.curvature) {
    const double chord = along_.norm();
    along_ = along_ * (1 / chord);
    half_ = 0.5 * chord;
    sine_ = std::clamp(curvature_ * half_, -1.0, 1.0);
    cosine_ = std::sqrt(1 - sine_ * sine_);
}

TPoint2D BentWall::turned(const TPoint2D& inMap) const {
    return {along_.x * inMap.x + along_.y * inMap.y, along_.x * inMap.y - along_.y * inMap.x};
}

TPoint2D BentWall::toLocal(const TPoint2D& place) const { return turned(place - middle_); }

TPoint2D BentWall::turnedBack(const TPoint2D& local) const {
    return {along_.x * local.x - along_.y * local.y, along_.y * local.x + along_.x * local.y};
}

double BentWall::length() const { return 2 * std::asin(sine_) / curvature_; }

double BentWall::leftOf(const TPoint2D& place) const {
    const TPoint2D p = toLocal(place);
    const double outside = curvature_ * (p.x * p.x + p.y * p.y - half_ * half_) - 2 * cosine_ * p.y;
    return -outside / (rootOfSquares(curvature_ * p.x, cosine_ - curvature_ * p.y) + 1);
}

TPoint2D BentWall::leftNormal(const TPoint2D& place) const {
    const TPoint2D p = toLocal(place);
    const TPoint2D normal(-curvature_ * p.x, cosine_ - curvature_ * p.y);
    const double norm = normal.norm();
    return turnedBack(norm > 0 ? normal * (1 / norm) : TPoint2D(0, 1));  // any, at the centre
}

bool BentWall::facesArc(const TPoint2D& place) const {
    const TPoint2D p = toLocal(place);
    return std::abs(p.x) * cosine_ <= half_ * (cosine_ - curvature_ * p.y);
}

double BentWall::share(const TPoint2D& place) const {
    const TPoint2D p = toLocal(place);
    const double angle = std::atan2(curvature_ * p.x, cosine_ - curvature_ * p.y);
    return 0.5 * (1 + angle / std::asin(sine_));
}

TPoint2D BentWall::placeAt(double share) const {
    const double end = std::asin(sine_), angle = (2 * share - 1) * end;
    // v = (cos(end) - cos(angle)) / k
    const double v = -2 * std::sin(0.5 * (end + angle)) * std::sin(0.5 * (end - angle));
    return middle_ + turnedBack({std::sin(angle) / curvature_, v / curvature_});
}

double BentWall::reach(const TPoint2D& direction, double ofEnds) const {
    const TPoint2D d = turned(direction);
    const double outward = curvature_ > 0 ? -d.y : d.y;  // cosine to the middle of the arc
    if (outward < cosine_) return ofEnds;
    const double ofMiddle = direction.x * middle_.x + direction.y * middle_.y;
    return std::max(ofEnds, ofMiddle + (1 - cosine_ * outward) / std::abs(curvature_));
}

BentWall::Crossings BentWall::cross(const TPoint2D& origin, const TPoint2D& direction) const {
    // k t^2 + 2 b t + f = 0 of the range t, without the cancellation of the school formula.
    const TPoint2D o = toLocal(origin), d = turned(direction);
    const double b = curvature_ * (o.x * d.x + o.y * d.y) - cosine_ * d.y;
    const double f = curvature_ * (o.x * o.x + o.y * o.y - half_ * half_) - 2 * cosine_ * o.y;
    const double square = b * b - curvature_ * f;
    const double root = std::sqrt(std::max(square, 0.0));
    const double q = b < 0 ? root - b : -root - b;
    if (q == 0) return {0, 0, false};  // comes nearest where it begins
    if (b < 0) return {q / curvature_, f / q, square > 0};
    return {f / q, q / curvature_, square > 0};
}

bool BentWall::dips(const TPoint2D& direction, bool onRight) const {
    const double cosine = turned(direction).x;  // to the chord
    const double toBulge = (curvature_ > 0) == onRight ? -cosine : cosine;
    return toBulge > cosine_;
}

}  // namespace offmap::core
