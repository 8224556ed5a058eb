// SPDX-License-Identifier: BSD-3-Clause
#include "SvgPen.h"

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace offmap::maps::svg {

using Eigen::Vector2d;

/// Part of an ellipse: centre + axes * (cos t, sin t), t from start on, in user units.
struct EllipticalArc {
    Vector2d centre;
    Eigen::Matrix2d axes;
    double start, sweep;  ///< [rad] of t; the sweep may be negative

    Vector2d at(double t) const { return centre + axes * Vector2d(std::cos(t), std::sin(t)); }
};

namespace {

constexpr double pi = std::numbers::pi;
constexpr double farthest = 1e7;  // [m] that a place may be off the origin: a quarter of the globe
constexpr size_t mostWalls = 10'000'000;

/// At least one, and no more than a curve that fits a map can need.
int pieces(double number) {
    constexpr int most = 10'000;
    return number < most ? std::max(1, static_cast<int>(std::ceil(number))) : most;
}

double angleOf(const Vector2d& v) { return std::atan2(v.y(), v.x()); }

/// Of the step from a place: the centre and the parameters of the ellipse through both ends, by
/// SVG 1.1, F.6.5; radii that are too small are enlarged by F.6.6.
EllipticalArc ellipseOf(const Vector2d& from, const EllipticalStep& step) {
    const Eigen::Rotation2Dd turn(mrpt::DEG2RAD(step.xAxisRotationDeg));
    Vector2d radii = step.radii.cwiseAbs();
    const Vector2d half = turn.inverse() * (0.5 * (from - step.end));
    const double excess = half.cwiseQuotient(radii).squaredNorm();
    if (excess > 1) radii *= std::sqrt(excess);
    // on the unit circle: the centre lies off the middle of the chord
    const Vector2d onCircle = half.cwiseQuotient(radii);
    const double halfChord = onCircle.norm();
    const double height = std::sqrt(std::max(0.0, 1 - halfChord * halfChord));
    const double side = step.isLarge == step.isSweep ? -1 : 1;
    const Vector2d toCentre = side * height / halfChord * Vector2d(onCircle.y(), -onCircle.x());
    EllipticalArc arc;
    arc.axes = turn.toRotationMatrix() * radii.asDiagonal();
    arc.centre = 0.5 * (from + step.end) + arc.axes * toCentre;
    arc.start = angleOf(onCircle - toCentre);
    arc.sweep = std::remainder(angleOf(-onCircle - toCentre) - arc.start, 2 * pi);
    if (step.isSweep && arc.sweep < 0) arc.sweep += 2 * pi;
    if (!step.isSweep && arc.sweep > 0) arc.sweep -= 2 * pi;
    return arc;
}

}  // namespace

Pen::Pen(const Eigen::Affine2d& userToMap, double realPerMap, const core::Wall& like,
         std::vector<core::Wall>& walls)
    : userToMap_(userToMap), flatnessInMap_(flatness / realPerMap), like_(like), walls_(walls) {}

void Pen::add(const Vector2d& toInMap, double curvature) {
    const Vector2d from = std::exchange(hereInMap_, toInMap);
    const double length = (toInMap - from).norm();
    if (length == 0) return;
    if (!(from.cwiseAbs().maxCoeff() <= farthest && toInMap.cwiseAbs().maxCoeff() <= farthest)) {
        throw std::runtime_error(
            fmt::format("reaches to ({:g}, {:g}) m, more than {:g} m off; check its unit, or give "
                        "it: --map-units mm",
                        toInMap.x(), toInMap.y(), farthest));
    }
    if (walls_.size() >= mostWalls) {
        throw std::runtime_error(
            fmt::format("more than {} lines; leave out what is no wall", mostWalls));
    }
    core::Wall wall = like_;
    wall.line = {{from.x(), from.y()}, {toInMap.x(), toInMap.y()}};
    if (wall.line.length() == 0) return;
    wall.curvature = curvature;
    walls_.push_back(wall);
}

void Pen::moveTo(const Vector2d& place) {
    startInUser_ = hereInUser_ = place;
    hereInMap_ = userToMap_ * place;
}

void Pen::lineTo(const Vector2d& end) {
    hereInUser_ = end;
    add(userToMap_ * end);
}

void Pen::close() { lineTo(startInUser_); }

void Pen::curveTo(const Vector2d& control1, const Vector2d& control2, const Vector2d& end) {
    const Vector2d p0 = hereInMap_, p1 = userToMap_ * control1, p2 = userToMap_ * control2,
                   p3 = userToMap_ * end;
    // A chord over the share h of the way is at most h^2/8 max|B''| off, max|B''| = 6 bend.
    const double bend = std::max((p0 - 2 * p1 + p2).norm(), (p1 - 2 * p2 + p3).norm());
    const int n = pieces(std::sqrt(0.75 * bend / flatnessInMap_));
    for (int i = 1; i < n; ++i) {
        const double t = static_cast<double>(i) / n, s = 1 - t;
        add(s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3);
    }
    add(p3);
    hereInUser_ = end;
}

void Pen::arcTo(const EllipticalStep& step) {
    const Vector2d from = hereInUser_;
    if (step.radii.x() == 0 || step.radii.y() == 0 || from == step.end) return lineTo(step.end);
    follow(ellipseOf(from, step), userToMap_ * step.end);
    hereInUser_ = step.end;
}

void Pen::ellipse(const Vector2d& centre, const Vector2d& radii) {
    const Eigen::Matrix2d axes = radii.asDiagonal();
    const EllipticalArc whole{centre, axes, 0, 2 * pi};
    moveTo(whole.at(0));
    const Vector2d startInMap = hereInMap_;
    follow(whole, startInMap);
}

void Pen::follow(const EllipticalArc& arc, const Vector2d& endInMap) {
    const Eigen::Matrix2d axes = userToMap_.linear() * arc.axes;
    // the half-axes of the ellipse in the map are the singular values
    const double sum = std::hypot(axes(0, 0) + axes(1, 1), axes(1, 0) - axes(0, 1));
    const double difference = std::hypot(axes(0, 0) - axes(1, 1), axes(1, 0) + axes(0, 1));
    const double larger = 0.5 * (sum + difference), smaller = 0.5 * std::abs(sum - difference);
    const bool isCircle = larger - smaller <= 0.1 * flatnessInMap_ && smaller > 10 * flatnessInMap_;
    // Quarters of a circle; else a chord over the angle dt is at most larger dt^2/8 off.
    const double steps = isCircle ? 2 / pi - 1e-9 : std::sqrt(larger / (8 * flatnessInMap_));
    const int n = pieces(std::abs(arc.sweep) * steps);
    const double dt = arc.sweep / n, sense = axes.determinant() > 0 ? 1 : -1;
    for (int i = 1; i <= n; ++i) {
        const Vector2d end = i == n ? endInMap : userToMap_ * arc.at(arc.start + i * dt);
        const double chord = (end - hereInMap_).norm();
        add(end, isCircle && chord > 0 ? sense * 2 * std::sin(0.5 * dt) / chord : 0);
    }
}

}  // namespace offmap::maps::svg
