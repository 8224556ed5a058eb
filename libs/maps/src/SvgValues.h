// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <string_view>
#include <vector>

// The grammar of SVG's attributes, without the tree that they stand in.

namespace offmap::maps::svg {

/// The end of a path's step that follows an ellipse. All in user units, the angle in degrees, as
/// SVG has it.
struct EllipticalStep {
    Eigen::Vector2d radii;
    double xAxisRotationDeg;
    bool isLarge, isSweep;
    Eigen::Vector2d end;
};

/// Follows a path, step by step; all places are absolute, in user units.
class PathFollower {
 public:
    PathFollower() = default;
    PathFollower(const PathFollower&) = delete;
    PathFollower& operator=(const PathFollower&) = delete;
    virtual ~PathFollower() = default;

    virtual void moveTo(const Eigen::Vector2d& place) = 0;
    virtual void lineTo(const Eigen::Vector2d& end) = 0;
    virtual void curveTo(const Eigen::Vector2d& control1, const Eigen::Vector2d& control2,
                         const Eigen::Vector2d& end) = 0;  ///< cubic
    virtual void arcTo(const EllipticalStep& step) = 0;
    virtual void close() = 0;
};

/// \return false if the text is no path data; the steps before the fault have been followed
bool followPath(std::string_view text, PathFollower& follower);

/// None if it is no list of transforms.
std::optional<Eigen::Affine2d> transformOf(std::string_view text);

/// [user units, px] None if it is no length. \param whole of which a percentage is
std::optional<double> lengthOf(std::string_view text, double whole);

/// Numbers between blanks or commas. None if anything else stands there.
std::optional<std::vector<double>> numbersOf(std::string_view text);

}  // namespace offmap::maps::svg
