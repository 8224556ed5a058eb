// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/PlacedReturns.h>

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <optional>
#include <span>

namespace offmap::view {

/// What lies under a few pixels of a picture: a cone from the eye or, with parallel beams, a
/// cylinder.
struct ViewRay {
    mrpt::math::TPoint3D origin;     ///< [m] map frame: the eye, or where the beam starts
    mrpt::math::TPoint3D direction;  ///< of any length but 0
    double angle = 0;                ///< [rad] from the middle to the rim of the cone, < pi/2
    double radius = 0;               ///< [m] of the cylinder; added to the cone's
};

/// The return nearest to the viewer that lies within the ray, as an index into the returns.
/// \param hidden 0 or 1 per return: those that are not to be seen; may be empty
/// \throw std::invalid_argument if `hidden` is of another length, or the ray has no direction
std::optional<size_t> pick(const PlacedReturns& returns, const ViewRay& ray,
                           std::span<const uint8_t> hidden = {});

}  // namespace offmap::view
