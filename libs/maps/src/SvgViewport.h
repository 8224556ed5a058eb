// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapOptions.h>

#include <Eigen/Geometry>

#include <optional>
#include <pugixml.hpp>
#include <string>

namespace offmap::maps::svg {

/// Where what an element holds is drawn.
struct Viewport {
    Eigen::Affine2d toOuter;  ///< from the user units inside to those outside
    Eigen::Vector2d size;     ///< [user units inside] of which percentages are
};

/// Of an <svg> inside another one, or of a <symbol> that a <use> shows. \param outer size of the
/// viewport around it \param sized the element whose x, y, width and height count
/// \throw std::runtime_error for an attribute that cannot be read
Viewport innerViewport(const pugi::xml_node& element, const pugi::xml_node& sized,
                       const Eigen::Vector2d& outer);

/// The whole drawing's.
struct Sheet {
    Eigen::Affine2d userToMap;              ///< from user units to [m]
    Eigen::Vector2d size;                   ///< [user units]
    std::optional<Eigen::Vector2d> extent;  ///< [m] width and height, if they are known
    Eigen::Vector2d lowerLeft{0, 0};        ///< [m] its place in the map
    std::string note;                       ///< what a user unit is, and why
};

/// \throw std::runtime_error for an attribute that cannot be read
Sheet sheetOf(const pugi::xml_node& root, const MapOptions& options);

/// [user units] \param whole of which a percentage is
/// \throw std::runtime_error if it cannot be read
double lengthIn(const pugi::xml_node& element, const char* attribute, double whole,
                double otherwise);

}  // namespace offmap::maps::svg
