// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/World.h>

#include <cstdint>
#include <optional>

namespace offmap::evaluation {

/// Distance in top view between the outline of a shape and a line; 0 where they meet. [m]
double gap(const Panel& panel, const mrpt::math::TSegment2D& line);
double gap(const Mesh& mesh, const mrpt::math::TSegment2D& line);
double gap(const Cylinder& cylinder, const mrpt::math::TSegment2D& line);
double gap(const Box& box, const mrpt::math::TSegment2D& line);

/// The gap between an object and the nearest wall of the map, in top view; none for what is not an
/// object and for a map without walls. [m]
/// \throw std::out_of_range if the world has no such surface
std::optional<double> standOffOf(const World& world, uint32_t surface);

}  // namespace offmap::evaluation
