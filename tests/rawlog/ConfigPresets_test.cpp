// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ParameterValues.h"
#include "../support/SharedData.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/ParameterTable.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

// The files of the folder config/.

namespace offmap::rawlog {

namespace {

/// A configuration in which every parameter with more than one value differs from its default.
Config allDifferent() {
    Config config;
    for (const Parameter& p : parameters()) {
        p.setNumbers(config, test::otherThan(p, p.numbers(config)));
    }
    return config;
}

}  // namespace

TEST(DefaultYaml, holdsEveryKeyWithItsDefault) {
    Config config = allDifferent();
    const auto keysSet = applyYaml(config, test::sourceFile("config/default.yaml"));
    std::vector<std::string> allKeys;
    for (const Parameter& p : parameters()) {
        allKeys.emplace_back(p.key);
        EXPECT_EQ(p.read(config), p.read(Config{})) << p.key;
    }
    EXPECT_EQ(keysSet, allKeys);
}

TEST(DefaultYaml, everyEntryStatesItsUnit) {
    std::ifstream file(test::sourceFile("config/default.yaml"));
    size_t entry = 0;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("  ") || line.find_first_not_of(' ') == line.find('#')) continue;
        ASSERT_LT(entry, parameters().size()) << line;
        const Parameter& p = parameters()[entry++];
        EXPECT_THAT(line, testing::HasSubstr("# [" + std::string(p.unit) + "] ")) << p.key;
    }
    EXPECT_EQ(entry, parameters().size());
}

class Preset : public testing::TestWithParam<const char*> {};

TEST_P(Preset, holdsOnlyWhatDiffersFromTheDefault) {
    Config config;
    const auto keysSet = applyYaml(config, test::sourceFile(GetParam()));
    EXPECT_FALSE(keysSet.empty());
    for (const std::string& key : keysSet) {
        const Parameter& p = findParameter(key);
        EXPECT_NE(p.read(config), p.read(Config{})) << key;
    }
    EXPECT_NO_THROW(config.validate());
}

TEST_P(Preset, saysInItsFirstLineForWhomItIs) {
    std::ifstream file(test::sourceFile(GetParam()));
    std::string line;
    std::getline(file, line);
    EXPECT_THAT(line, testing::StartsWith("# For "));
}

INSTANTIATE_TEST_SUITE_P(ConfigFolder, Preset,
                         testing::Values("config/indoor.yaml", "config/outdoor.yaml",
                                         "config/vlp16.yaml", "config/hdl32.yaml",
                                         "config/depth_camera.yaml"));

TEST(Presets, differFromTheDefaultInTheirDirection) {
    const auto loaded = [](const char* file) {
        Config config;
        applyYaml(config, test::sourceFile(file));
        return config;
    };
    const Config usual;
    EXPECT_LT(loaded("config/indoor.yaml").reduction.matching.maxRange,
              usual.reduction.matching.maxRange);
    EXPECT_GT(loaded("config/outdoor.yaml").reduction.matching.maxRange,
              usual.reduction.matching.maxRange);
    EXPECT_GT(loaded("config/outdoor.yaml").map.sigma, usual.map.sigma);
    EXPECT_GT(loaded("config/vlp16.yaml").reduction.vertical.maxGap,
              usual.reduction.vertical.maxGap);
    EXPECT_LT(loaded("config/vlp16.yaml").reduction.vertical.minPoints,
              usual.reduction.vertical.minPoints);
    // Between a scanner with half the rings and one with many.
    const Config hdl32 = loaded("config/hdl32.yaml");
    EXPECT_GT(hdl32.reduction.vertical.maxGap, usual.reduction.vertical.maxGap);
    EXPECT_LT(hdl32.reduction.vertical.maxGap,
              loaded("config/vlp16.yaml").reduction.vertical.maxGap);
    EXPECT_GT(loaded("config/depth_camera.yaml").reduction.vertical.maxPointToLine,
              usual.reduction.vertical.maxPointToLine);
}

}  // namespace offmap::rawlog
