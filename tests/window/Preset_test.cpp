// SPDX-License-Identifier: BSD-3-Clause
#include "Preset.h"

#include "../support/ParameterValues.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/LayerSettings.h>
#include <offmap/rawlog/ParameterTable.h>

#include <gtest/gtest.h>

namespace offmap::window {

namespace {

rawlog::Config configOf(std::initializer_list<const char*> settings) {
    rawlog::Config config;
    for (const char* setting : settings) rawlog::applySetting(config, setting);
    return config;
}

rawlog::Config readBack(const std::string& preset) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "preset.yaml", preset);
    rawlog::Config config;
    rawlog::applyYaml(config, folder / "preset.yaml");
    return config;
}

}  // namespace

TEST(Preset, defaultIsAFileThatSetsNothing) {
    EXPECT_EQ(presetOf({}), "# What differs from the default.\n{}\n");
    EXPECT_EQ(presetOf(readBack(presetOf({}))), presetOf({}));
}

TEST(Preset, holdsOnlyWhatDiffersSectionBySection) {
    const auto config =
        configOf({"map.sigma_m=0.07", "vertical.max_tilt_deg=4", "vertical.min_points=6",
                  "extension.enabled=false", "sensor.elevations_deg=[-15, 1.5]"});
    EXPECT_EQ(presetOf(config),
              "# What differs from the default.\n"
              "vertical:\n"
              "  max_tilt_deg: 4\n"
              "  min_points: 6\n"
              "extension:\n"
              "  enabled: false\n"
              "sensor:\n"
              "  elevations_deg: [-15, 1.5]\n"
              "map:\n"
              "  sigma_m: 0.07\n");
}

TEST(Preset, everyParameterIsReadBackAtBothLimits) {
    for (const rawlog::Parameter& p : rawlog::parameters()) {
        for (const auto& limit : test::limitsOf(p)) {
            rawlog::Config config;
            p.setNumbers(config, limit);
            try {
                config.validate();
            } catch (const std::invalid_argument&) {
                continue;  // of a List whose numbers contradict each other
            }
            EXPECT_EQ(p.text(readBack(presetOf(config))), p.text(config)) << p.key;
        }
    }
}

TEST(Preset, singleSensorsKeepTheirSettingsUnderAnyLabel) {
    const auto config =
        configOf({"sensors.FRONT: \"a\".min_range_m=0.5", "sensors.REAR.elevations_deg=[-1, 1]"});
    EXPECT_EQ(readBack(presetOf(config)).sensors, config.sensors);
}

TEST(Preset, layersKeepTheirOrderAndRulesThatOnlyComeFirst) {
    const auto config = configOf({"layers.door main.present=true", "layers.door*.present=false",
                                  "layers.A*.sigma_m=0.05", "layers.A*.z_min_m=-0.1"});
    const auto& layers = readBack(presetOf(config)).map.layers;
    ASSERT_EQ(layers.size(), 3);
    EXPECT_EQ(layers[0].layer, "door main");
    EXPECT_TRUE(layers[0].present);
    EXPECT_EQ(layers[1].layer, "door*");
    EXPECT_FALSE(layers[1].present);
    EXPECT_EQ(layers[2].sigma, 0.05);
    EXPECT_EQ(layers[2].zMin, -0.1);
    EXPECT_FALSE(layers[2].zMax);
}

TEST(Preset, isSavedOverAnOlderOneAndLeavesNothingBeside) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "own.yaml", "older");
    savePreset(folder / "own.yaml", configOf({"vertical.min_points=7"}));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"own.yaml"});
    EXPECT_EQ(loadPreset(folder / "own.yaml", {}).reduction.vertical.minPoints, 7U);
}

TEST(Preset, aFolderThatIsNotThereIsNamed) {
    const test::TemporaryFolder folder;
    try {
        savePreset(folder / "missing" / "own.yaml", {});
        FAIL() << "saved";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("missing"), std::string::npos) << error.what();
    }
}

TEST(Preset, loadingStartsFromTheDefaultAndKeepsMountings) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "own.yaml", "vertical: {min_points: 9}\n");
    auto before = configOf({"vertical.max_tilt_deg=4"});
    before.mountings["LIDAR"].x = 0.3;
    const auto after = loadPreset(folder / "own.yaml", before);
    EXPECT_EQ(after.reduction.vertical.minPoints, 9U);
    EXPECT_EQ(after.reduction.vertical.maxTilt, rawlog::Config{}.reduction.vertical.maxTilt);
    EXPECT_EQ(after.mountings.at("LIDAR").x, 0.3);
}

}  // namespace offmap::window
