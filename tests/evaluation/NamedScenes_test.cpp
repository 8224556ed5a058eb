// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/NamedScenes.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace offmap::evaluation {

TEST(SceneNamed, everyNameGivesASceneWhoseMapIsSeen) {
    for (const std::string_view name : sceneNames()) {
        const Scene scene = sceneNamed(name, 5).value();
        const auto truth = simulate(scene.world, paperScanner(), scene.sensor, {}, 1).truth;
        EXPECT_TRUE(std::any_of(truth.begin(), truth.end(), [](const PointTruth& p) {
            return p.mapped;
        })) << name;
    }
}

TEST(SceneNamed, onlyRandomScenesDependOnTheSeed) {
    for (const std::string_view name : sceneNames()) {
        const auto mapAt = [name](uint64_t seed) {
            return mapOf(sceneNamed(name, seed).value().world).front().line.point1;
        };
        const bool random = name.starts_with("random_");
        EXPECT_EQ(mapAt(1) != mapAt(2), random) << name;
    }
}

TEST(SceneNamed, unknownNameIsNoScene) { EXPECT_FALSE(sceneNamed("moon", 1)); }

}  // namespace offmap::evaluation
