// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/NamedScenes.h>
#include <offmap/evaluation/SampleWorlds.h>

namespace offmap::evaluation {

namespace {

Scene sceneAt(World world, double x, double y, double z) {
    return {std::move(world), {.sensorInMap = {x, y, z, 0, 0, 0}}};
}

struct NamedScene {
    std::string_view name;
    Scene (*make)(uint64_t seed);
};

constexpr NamedScene namedScenes[] = {
    {"office_room", [](uint64_t) { return sceneAt(officeRoom(), 2, 2.5, 0.6); }},
    {"corridor", [](uint64_t) { return sceneAt(corridor(), 4, 0, 0.6); }},
    {"parking_lot", [](uint64_t) { return sceneAt(parkingLot(), 0, 0, 1.0); }},
    {"bare_corridor", [](uint64_t) { return sceneAt(bareCorridor(), 0, 0.2, 0.8); }},
    {"curved_hall", [](uint64_t) { return sceneAt(curvedHall(0), -1, -2, 0.8); }},
    {"random_room", [](uint64_t seed) { return randomRoom(seed); }},
    {"random_corridor", [](uint64_t seed) { return randomCorridor(seed); }},
    {"random_corner", [](uint64_t seed) { return randomCorner(seed); }},
    {"random_scene", [](uint64_t seed) { return randomScene(seed); }},
};

}  // namespace

std::vector<std::string_view> sceneNames() {
    std::vector<std::string_view> names;
    for (const NamedScene& scene : namedScenes) names.push_back(scene.name);
    return names;
}

std::optional<Scene> sceneNamed(std::string_view name, uint64_t seed) {
    for (const NamedScene& scene : namedScenes) {
        if (scene.name == name) return scene.make(seed);
    }
    return std::nullopt;
}

}  // namespace offmap::evaluation
