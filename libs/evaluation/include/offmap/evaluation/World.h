// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/evaluation/Shapes.h>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace offmap::evaluation {

enum class SurfaceKind : uint8_t { Wall, Floor, Ceiling, Object };

/// What a ray can meet. A surface's id is its place in World::surfaces().
struct Surface {
    SurfaceKind kind;
    std::optional<uint32_t> wall;  ///< index into the map of the wall that shows it
    std::variant<Panel, Mesh, Plane, Cylinder, Box> shape;
    double reflectivity = 0.5;  ///< share of the light that it sends back when met squarely

    bool mapped() const { return wall.has_value(); }
};

struct WorldHit {
    double range;      ///< [m]
    uint32_t surface;  ///< its id
};

/// What truly stands there, and what the map says of it. Map frame, z up, in [m].
class World {
 public:
    /// Draws a wall into the map only. \return its index in the map
    uint32_t addToMap(const core::Wall& wall);

    /// Each adds a surface and returns its id.
    /// \throw std::invalid_argument for a shape without extent
    uint32_t addPanel(const Panel& panel, std::optional<uint32_t> wallInMap = {});
    uint32_t addObject(const Panel& panel);
    uint32_t addObject(const Mesh& mesh);
    uint32_t addObject(const Cylinder& cylinder);
    uint32_t addObject(const Box& box);
    uint32_t addFloor(double z = 0);
    uint32_t addCeiling(double z);

    /// A panel that the map shows along its full length.
    uint32_t addMappedPanel(const Panel& panel) {
        return addPanel(panel, addToMap({.line = panel.line}));
    }

    /// \throw std::invalid_argument unless in [0, 1] \throw std::out_of_range if there is no such
    /// surface
    void setReflectivity(uint32_t surface, double reflectivity);

    const std::vector<Surface>& surfaces() const { return surfaces_; }

    /// The first surface on a ray, exactly. \param direction unit vector
    std::optional<WorldHit> castRay(const mrpt::math::TPoint3D& origin,
                                    const mrpt::math::TVector3D& direction, double maxRange) const;

    friend std::vector<core::Wall> mapOf(const World& world) { return world.map_; }

 private:
    uint32_t add(const Surface& surface);

    std::vector<core::Wall> map_;
    std::vector<Surface> surfaces_;
    std::vector<BoundingCircle> bounds_;  ///< one per surface
};

/// The walls that the map shows.
std::vector<core::Wall> mapOf(const World& world);

}  // namespace offmap::evaluation
