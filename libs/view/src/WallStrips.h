// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/math/TPoint3D.h>
#include <mrpt/math/TSegment3D.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/TTriangle.h>

#include <vector>

namespace offmap::view {

/// Walls as upright strips: their edges, and the surfaces between them.
struct WallStrips {
    std::vector<mrpt::math::TSegment3D> edges;       ///< [m] map frame
    std::vector<mrpt::opengl::TTriangle> triangles;  ///< [m] map frame

    /// \param floor, ceiling [m] z that is drawn at most
    void add(const core::Wall& wall, double floor, double ceiling);

    mrpt::opengl::CSetOfLines::Ptr lines(const mrpt::img::TColor& colour, float width) const;
    /// Without shading. \param opacity [0, 255]
    mrpt::opengl::CSetOfTriangles::Ptr surfaces(const mrpt::img::TColor& colour,
                                                uint8_t opacity) const;
};

}  // namespace offmap::view
