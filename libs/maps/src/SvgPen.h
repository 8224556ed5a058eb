// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SvgValues.h"

#include <offmap/core/Wall.h>

#include <Eigen/Geometry>

#include <vector>

namespace offmap::maps::svg {

struct EllipticalArc;

/// Turns the steps of paths into walls: arcs of circles into arcs, other curves into lines that
/// keep within flatness.
class Pen : public PathFollower {
 public:
    static constexpr double flatness = 0.001;  ///< [m] at real size

    /// \param realPerMap real lengths to those of the map, which is scaled later
    Pen(const Eigen::Affine2d& userToMap, double realPerMap, const core::Wall& like,
        std::vector<core::Wall>& walls);

    void moveTo(const Eigen::Vector2d& place) override;
    void lineTo(const Eigen::Vector2d& end) override;
    void curveTo(const Eigen::Vector2d& control1, const Eigen::Vector2d& control2,
                 const Eigen::Vector2d& end) override;
    void arcTo(const EllipticalStep& step) override;
    void close() override;

    /// A whole ellipse, in the sense of the axes.
    void ellipse(const Eigen::Vector2d& centre, const Eigen::Vector2d& radii);

 private:
    void add(const Eigen::Vector2d& toInMap, double curvature = 0);
    void follow(const EllipticalArc& arc, const Eigen::Vector2d& endInMap);

    Eigen::Affine2d userToMap_;
    double flatnessInMap_;  // [m]
    core::Wall like_;
    std::vector<core::Wall>& walls_;
    Eigen::Vector2d startInUser_{0, 0}, hereInUser_{0, 0}, hereInMap_{0, 0};
};

}  // namespace offmap::maps::svg
