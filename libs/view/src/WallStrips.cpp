// SPDX-License-Identifier: BSD-3-Clause
#include "WallStrips.h"

#include <offmap/core/WallGeometry.h>

#include <algorithm>
#include <cmath>

namespace offmap::view {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

namespace {

/// How many straight pieces look like the wall.
int piecesOf(const core::Wall& wall) {
    constexpr double angle = 0.1;  // [rad] of a piece that looks straight
    if (wall.curvature == 0) return 1;
    const double turn = std::abs(wall.curvature) * core::lengthOf(wall);
    return std::max(1, static_cast<int>(std::ceil(turn / angle)));
}

}  // namespace

void WallStrips::add(const core::Wall& wall, double floor, double ceiling) {
    const double low = std::max(wall.height.min(), floor);
    const double high = std::max(low, std::min(wall.height.max(), ceiling));
    const auto at = [](const TPoint2D& p, double z) { return TPoint3D{p.x, p.y, z}; };
    const int pieces = piecesOf(wall);
    TPoint2D a = wall.line.point1;
    edges.emplace_back(at(a, low), at(a, high));
    for (int i = 1; i <= pieces; ++i) {
        const auto b = i == pieces ? wall.line.point2 : core::placeAt(wall, double(i) / pieces);
        edges.emplace_back(at(a, low), at(b, low));
        edges.emplace_back(at(a, high), at(b, high));
        triangles.emplace_back(at(a, low), at(b, low), at(b, high));
        triangles.emplace_back(at(a, low), at(b, high), at(a, high));
        a = b;
    }
    edges.emplace_back(at(a, low), at(a, high));
}

mrpt::opengl::CSetOfLines::Ptr WallStrips::lines(const mrpt::img::TColor& colour,
                                                 float width) const {
    auto lines = mrpt::opengl::CSetOfLines::Create();
    lines->appendLines(edges.begin(), edges.end());
    lines->setColor_u8(colour);
    lines->setLineWidth(width);
    return lines;
}

mrpt::opengl::CSetOfTriangles::Ptr WallStrips::surfaces(const mrpt::img::TColor& colour,
                                                        uint8_t opacity) const {
    auto surfaces = mrpt::opengl::CSetOfTriangles::Create();
    surfaces->insertTriangles(triangles.begin(), triangles.end());
    surfaces->setColor_u8(colour);
    surfaces->setColorA_u8(opacity);
    surfaces->enableLight(false);
    return surfaces;
}

}  // namespace offmap::view
