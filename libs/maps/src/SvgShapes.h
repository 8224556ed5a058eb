// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SvgPen.h"

#include <Eigen/Geometry>

#include <pugixml.hpp>
#include <string_view>

namespace offmap::maps::svg {

/// Whether it is one of path, line, polyline, polygon, rect, circle, ellipse.
bool isShape(std::string_view element);

/// Draws the outline of such an element. \param viewport [user units] size
/// \throw std::runtime_error telling what is wrong with it
void drawShape(const pugi::xml_node& element, std::string_view name,
               const Eigen::Vector2d& viewport, Pen& pen);

}  // namespace offmap::maps::svg
