// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/LayerSettings.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace offmap::rawlog {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> apply(Config& config, const std::string& yaml) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "own.yaml", yaml);
    return applyYaml(config, folder / "own.yaml");
}

std::string errorOfText(const std::string& yaml) {
    Config config;
    try {
        apply(config, yaml);
    } catch (const std::runtime_error& e) {
        EXPECT_TRUE(config.map.layers.empty()) << yaml;
        return e.what();
    }
    return "no error";
}

std::string errorOfSetting(Config config, const std::string& setting) {
    try {
        applySetting(config, setting);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

std::vector<std::string> texts(const Config& config) {
    std::vector<std::string> all;
    for (const auto& [key, text] : layerSettings(config)) {
        all.push_back(key.layer + "." + key.name + "=" + text);
    }
    return all;
}

}  // namespace

TEST(LayerSettings, fileSetsThemInItsOrder) {
    Config config;
    EXPECT_THAT(apply(config,
                      "layers:\n  COUNTER: {z_max_m: 1, sigma_m: 0.05}\n  'door*':\n"
                      "    present: false\n  empty:\nmap: {min_length_m: 0.1}\n"),
                ElementsAre("layers.COUNTER.z_max_m", "layers.COUNTER.sigma_m",
                            "layers.door*.present", "map.min_length_m"));
    EXPECT_THAT(texts(config),
                ElementsAre("COUNTER.sigma_m=0.05", "COUNTER.z_max_m=1", "door*.present=false"));
    ASSERT_EQ(config.map.layers.size(), 2U);
    EXPECT_FALSE(config.map.layers[0].zMin);
    EXPECT_TRUE(config.map.layers[0].present);
    EXPECT_EQ(config.map.minLength, 0.1);
}

TEST(LayerSettings, commandLineChangesThemOrAddsBehind) {
    Config config;
    apply(config, "layers: {b: {z_max_m: 1}}");
    applySetting(config, "layers.a.b=c.z_min_m = -1.5");
    applySetting(config, "layers.b.z_max_m=2");
    applySetting(config, "layers.b.present=false");
    EXPECT_THAT(texts(config), ElementsAre("b.z_max_m=2", "b.present=false", "a.b=c.z_min_m=-1.5"));
}

TEST(LayerSettings, wrongOneIsNamedWithItsPlaceAndTheNearest) {
    EXPECT_THAT(
        errorOfText("layers:\n  a:\n    z_mx_m: 1\n"),
        AllOf(HasSubstr(".yaml:3:"), HasSubstr("\"z_mx_m\""), HasSubstr("did you mean z_max_m?")));
    EXPECT_THAT(errorOfText("layers: {a: {colour: red}}"), HasSubstr("z_max_m and present"));
    EXPECT_THAT(errorOfText("layers: {a: {sigma_m: -1}}"), HasSubstr("0 ... 10 m"));
    EXPECT_THAT(errorOfText("layers: {a: {present: maybe}}"), HasSubstr("true or false"));
    EXPECT_THAT(errorOfText("layers: {a: {z_max_m: [1]}}"), HasSubstr("needs one value"));
    EXPECT_THAT(errorOfText("layers: {a: 1}"), HasSubstr("under their names"));
    EXPECT_THAT(errorOfText("layers: [a]"), HasSubstr("under their names"));
    EXPECT_THAT(errorOfText("layers: {a: {}, a: {}}"), HasSubstr("a second time"));
    EXPECT_THAT(errorOfSetting({}, "layers.present=false"), HasSubstr("names no layer"));
    EXPECT_THAT(errorOfSetting({}, "layers.a.sigma=1"), HasSubstr("did you mean sigma_m?"));
}

TEST(LayerSettings, heightsMustNotContradict) {
    EXPECT_THAT(errorOfText("layers: {a: {z_min_m: 2, z_max_m: 1}}"),
                HasSubstr("layers.a: z_min_m 2 is above z_max_m 1"));
    Config config;
    applySetting(config, "layers.a.z_max_m=1");
    EXPECT_THAT(errorOfSetting(config, "layers.a.z_min_m=1.5"), HasSubstr("is above z_max_m 1"));
    EXPECT_NO_THROW(applySetting(config, "layers.a.z_min_m=1"));
}

}  // namespace offmap::rawlog
