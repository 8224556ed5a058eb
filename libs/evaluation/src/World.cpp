// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/World.h>

#include <stdexcept>
#include <string>

namespace offmap::evaluation {

namespace {

void requireExtent(bool hasExtent, const char* shape) {
    if (!hasExtent) throw std::invalid_argument(std::string(shape) + " without extent");
}

}  // namespace

uint32_t World::add(const Surface& surface) {
    surfaces_.push_back(surface);
    bounds_.push_back(std::visit([](const auto& shape) { return boundsOf(shape); }, surface.shape));
    return static_cast<uint32_t>(surfaces_.size() - 1);
}

uint32_t World::addToMap(const core::Wall& wall) {
    map_.push_back(wall);
    return static_cast<uint32_t>(map_.size() - 1);
}

uint32_t World::addPanel(const Panel& panel, std::optional<uint32_t> wallInMap) {
    requireExtent(panel.line.length() > 0 && panel.height.width() > 0, "panel");
    if (wallInMap && *wallInMap >= map_.size()) {
        throw std::invalid_argument("panel of a wall that is not in the map");
    }
    return add({SurfaceKind::Wall, wallInMap, panel});
}

uint32_t World::addObject(const Panel& panel) {
    requireExtent(panel.line.length() > 0 && panel.height.width() > 0, "panel");
    return add({SurfaceKind::Object, std::nullopt, panel});
}

uint32_t World::addObject(const Mesh& mesh) {
    requireExtent(mesh.panel.line.length() > 0 && mesh.panel.height.width() > 0 && mesh.pitch > 0 &&
                      mesh.wire > 0,
                  "mesh");
    return add({SurfaceKind::Object, std::nullopt, mesh});
}

uint32_t World::addObject(const Cylinder& cylinder) {
    requireExtent(cylinder.radius > 0 && cylinder.height.width() > 0, "cylinder");
    return add({SurfaceKind::Object, std::nullopt, cylinder});
}

uint32_t World::addObject(const Box& box) {
    requireExtent(box.length > 0 && box.width > 0 && box.height.width() > 0, "box");
    return add({SurfaceKind::Object, std::nullopt, box});
}

uint32_t World::addFloor(double z) { return add({SurfaceKind::Floor, std::nullopt, Plane{z}}); }

uint32_t World::addCeiling(double z) { return add({SurfaceKind::Ceiling, std::nullopt, Plane{z}}); }

void World::setReflectivity(uint32_t surface, double reflectivity) {
    if (!(reflectivity >= 0 && reflectivity <= 1)) {
        throw std::invalid_argument("the reflectivity of a surface must be in [0, 1]");
    }
    surfaces_.at(surface).reflectivity = reflectivity;
}

std::optional<WorldHit> World::castRay(const mrpt::math::TPoint3D& origin,
                                       const mrpt::math::TVector3D& direction,
                                       double maxRange) const {
    const Ray ray{origin, direction};
    std::optional<WorldHit> nearest;
    for (uint32_t id = 0; id < surfaces_.size(); ++id) {
        if (!bounds_[id].mayMeet(ray)) continue;
        const std::optional<double> range =
            std::visit([&ray](const auto& shape) { return meet(ray, shape); }, surfaces_[id].shape);
        if (range && *range <= maxRange && (!nearest || *range < nearest->range)) {
            nearest = WorldHit{*range, id};
        }
    }
    return nearest;
}

}  // namespace offmap::evaluation
