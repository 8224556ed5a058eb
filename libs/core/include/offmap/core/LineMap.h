// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>
#include <offmap/core/WallGeometry.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace offmap::core {

/// Where a ray met the map.
struct RayHit {
    double range;         ///< [m] ground range from the ray's origin
    uint32_t wall;        ///< index into LineMap::walls()
    Incidence incidence;  ///< rho, between ray and wall
};

/// The wall nearest to a point.
struct NearestWall {
    double distance;  ///< [m]
    uint32_t wall;    ///< index into LineMap::walls()
};

/// The 2D map: walls behind a spatial index. Immutable, so one map may serve many threads.
class LineMap {
 public:
    /// \throw std::invalid_argument naming the wall if an end point or sigma is not finite, if
    /// sigma < 0, or if a wall has no length or bends by more than half a circle. An empty map is
    /// allowed.
    explicit LineMap(std::vector<Wall> walls);
    LineMap(LineMap&&) noexcept;
    LineMap& operator=(LineMap&&) noexcept;
    ~LineMap();

    const std::vector<Wall>& walls() const { return walls_; }

    /// [m] Of all walls; 0 of an empty map.
    double largestSigma() const { return largestSigma_; }

    /// The first wall on a ray that reaches to height z, if there is one within maxRange; eq. 1,
    /// d_map. \param origin [m] map frame \param direction unit vector \param z [m] map frame
    std::optional<RayHit> castRay(const mrpt::math::TPoint2D& origin,
                                  const mrpt::math::TPoint2D& direction, double maxRange,
                                  double z) const;

    /// The nearest wall that reaches to height z, if there is one within maxDistance.
    std::optional<NearestWall> nearestWall(const mrpt::math::TPoint2D& point, double maxDistance,
                                           double z) const;

    /// See WallGeometry.h; of straight walls it is at hand. \param wall index into walls()
    mrpt::math::TPoint2D normalAwayFrom(const mrpt::math::TPoint2D& beam, uint32_t wall,
                                        const mrpt::math::TPoint2D& place) const {
        if (walls_[wall].curvature != 0) return core::normalAwayFrom(beam, walls_[wall], place);
        return turnedAlong(beam, leftNormals_[wall]);
    }

    /// Whether any wall, at whatever height, comes within maxDistance of a point.
    bool hasWallWithin(const mrpt::math::TPoint2D& point, double maxDistance) const;

 private:
    struct Index;
    std::vector<Wall> walls_;
    std::vector<mrpt::math::TPoint2D> leftNormals_;  // of straight walls
    double largestSigma_ = 0;
    std::unique_ptr<const Index> index_;
};

}  // namespace offmap::core
