// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/ParameterTable.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A file of the test's own, gone with it.
struct TemporaryFile {
    explicit TemporaryFile(const std::string& text) { test::writeFile(path, text); }

    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "some.yaml";
};

std::string errorOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

bool equal(const Config& a, const Config& b) {
    return std::ranges::all_of(parameters(),
                               [&](const Parameter& p) { return p.read(a) == p.read(b); });
}

/// The message for a file of this text, which must not have changed the configuration.
std::string errorOfText(const std::string& text) {
    const TemporaryFile file(text);
    Config config;
    std::string error = errorOf([&] { applyYaml(config, file.path); });
    EXPECT_TRUE(equal(config, Config{})) << text;
    EXPECT_THAT(error, HasSubstr(file.path.string()));
    return error;
}

}  // namespace

TEST(ApplyYaml, setsWhatItMentionsAndNothingElse) {
    const TemporaryFile file(
        "vertical:\n  max_tilt_deg: 4.5\n  min_points: 7\nsensor: {pose_reference: turn}\n");
    Config config;
    EXPECT_THAT(
        applyYaml(config, file.path),
        ElementsAre("vertical.max_tilt_deg", "vertical.min_points", "sensor.pose_reference"));

    Config expected;
    expected.reduction.vertical.maxTilt = mrpt::DEG2RAD(4.5);
    expected.reduction.vertical.minPoints = 7;
    expected.sensor.poseReference = PoseReference::Turn;
    EXPECT_TRUE(equal(config, expected));
}

TEST(ApplyYaml, listIsAFlowOrABlockSequence) {
    for (const char* text : {"sensor: {elevations_deg: [-15, 1]}\n",
                             "sensor:\n  elevations_deg:\n    - -15\n    - 1\n",
                             "sensor: {elevations_deg: '-15, 1'}\n"}) {
        const TemporaryFile file(text);
        Config config;
        EXPECT_THAT(applyYaml(config, file.path), ElementsAre("sensor.elevations_deg"));
        EXPECT_EQ(findParameter("sensor.elevations_deg").text(config), "[-15, 1]") << text;
    }
}

TEST(ApplyYaml, wrongListNamesWhatIsAllowed) {
    for (const char* value : {"{a: 1}", "[[1]]", "['0,5']", "[~]", "~", "[up]", "[91]", "''"}) {
        EXPECT_THAT(errorOfText(std::string("sensor:\n  elevations_deg: ") + value + "\n"),
                    AllOf(HasSubstr(".yaml:2:"), HasSubstr("sensor.elevations_deg"),
                          HasSubstr("each -90 ... 90 deg")))
            << value;
    }
    EXPECT_THAT(errorOfText("sensor: {robot_box_m: [1, 2, 3]}\n"), HasSubstr("0 or 6 numbers"));
    EXPECT_THAT(errorOfText("sensor: {robot_box_m: [1, 0, -1, 1, 0, 1]}\n"),
                AllOf(HasSubstr("sensor.robot_box_m"), HasSubstr("min less than its max")));
}

TEST(ApplyYaml, laterFileGoesOverEarlierOne) {
    Config config;
    {
        const TemporaryFile first("map: {sigma_m: 0.1}\npose: {sigma_m: 0.2}\n");
        applyYaml(config, first.path);
    }
    const TemporaryFile second("map: {sigma_m: 0.3}\n");
    applyYaml(config, second.path);
    EXPECT_EQ(config.map.sigma, 0.3);
    EXPECT_EQ(config.pose.sigmaPosition, 0.2);
}

TEST(ApplyYaml, emptySectionSetsNothing) {
    const TemporaryFile file("map:\n  # sigma_m: 0.1\npose: {sigma_m: 0.2}\n");
    Config config;
    EXPECT_THAT(applyYaml(config, file.path), ElementsAre("pose.sigma_m"));
}

TEST(ApplyYaml, emptyMapSetsNothing) {
    const TemporaryFile file("{}\n");
    Config config;
    EXPECT_TRUE(applyYaml(config, file.path).empty());
}

TEST(ApplyYaml, missingFileOrFolderIsNamed) {
    Config config;
    EXPECT_THAT(errorOf([&] { applyYaml(config, "no/such.yaml"); }), HasSubstr("no/such.yaml"));
    EXPECT_THAT(errorOf([&] { applyYaml(config, testing::TempDir()); }),
                HasSubstr("cannot be read"));
}

TEST(ApplyYaml, unknownKeyNamesLineAndNearestKey) {
    EXPECT_THAT(errorOfText("map: {sigma_m: 0.1}\nvertical:\n  max_tilt: 4\n"),
                AllOf(HasSubstr(".yaml:3:"), HasSubstr("did you mean vertical.max_tilt_deg?")));
    EXPECT_THAT(errorOfText("vertcal: {max_tilt_deg: 4}\n"),
                HasSubstr("did you mean vertical.max_tilt_deg?"));
    EXPECT_THAT(errorOfText("max_tilt_deg: 4\n"), HasSubstr("did you mean vertical.max_tilt_deg?"));
    EXPECT_THAT(errorOfText("colours: {}\n"), HasSubstr("unknown key \"colours\""));
    EXPECT_THAT(errorOfText("colours:\n"), HasSubstr("unknown key \"colours\""));
    EXPECT_THAT(errorOfText("1: 2\n"), HasSubstr("unknown key \"1\""));
}

TEST(ApplyYaml, keyOutsideItsSectionSaysWhereItBelongs) {
    EXPECT_THAT(errorOfText("vertical.max_tilt_deg: 4\n"), HasSubstr("inside its section"));
}

TEST(ApplyYaml, wrongTypeNamesWhatIsAllowed) {
    EXPECT_THAT(errorOfText("\nvertical:\n  max_tilt_deg: steep\n"),
                AllOf(HasSubstr(".yaml:3:"), HasSubstr("vertical.max_tilt_deg"),
                      HasSubstr("\"steep\""), HasSubstr("0.1 ... 45 deg")));
    EXPECT_THAT(errorOfText("vertical: {max_tilt_deg: [1, 2]}\n"), HasSubstr("needs one value"));
    EXPECT_THAT(errorOfText("vertical:\n  max_tilt_deg:\n"), HasSubstr("needs one value"));
    EXPECT_THAT(errorOfText("vertical: 3\n"), HasSubstr("\"vertical\" is a section"));
    EXPECT_THAT(errorOfText("vertical: [max_tilt_deg]\n"), HasSubstr("\"vertical\" is a section"));
    EXPECT_THAT(errorOfText("matching: {method: quick}\n"), HasSubstr("allowed is paper"));
}

TEST(ApplyYaml, valueBeyondItsLimitsNamesThem) {
    EXPECT_THAT(errorOfText("vertical: {max_tilt_deg: 90}\n"), HasSubstr("0.1 ... 45 deg"));
    EXPECT_THAT(errorOfText("map: {sigma_m: .nan}\n"), HasSubstr("map.sigma_m"));
}

TEST(ApplyYaml, firstEntriesAreNotKeptWhenALaterOneFails) {
    EXPECT_THAT(errorOfText("map: {sigma_m: 0.1}\npose: {sigma_m: -1}\n"),
                HasSubstr("pose.sigma_m"));
}

TEST(ApplyYaml, repeatedKeyIsRefused) {
    EXPECT_THAT(errorOfText("map:\n  sigma_m: 0.1\n  sigma_m: 0.2\n"),
                AllOf(HasSubstr(".yaml:3:"), HasSubstr("second time")));
    EXPECT_THAT(errorOfText("map: {sigma_m: 0.1}\nmap: {sigma_m: 0.1}\n"),
                AllOf(HasSubstr(".yaml:2:"), HasSubstr("second time")));
}

TEST(ApplyYaml, otherThanOneMapIsRefused) {
    EXPECT_THAT(errorOfText(""), HasSubstr("holds no settings"));
    EXPECT_THAT(errorOfText("# map: {sigma_m: 0.1}\n"), HasSubstr("holds no settings"));
    EXPECT_THAT(errorOfText("- map\n- pose\n"), HasSubstr("stand in sections"));
    EXPECT_THAT(errorOfText("0.05\n"), HasSubstr("stand in sections"));
    EXPECT_THAT(errorOfText("map: {sigma_m: 0.1}\n---\npose: {sigma_m: 0.1}\n"),
                HasSubstr("second document"));
    EXPECT_THAT(errorOfText("[map]: 3\n"), HasSubstr("plain text"));
}

TEST(ApplyYaml, syntaxErrorNamesItsLine) {
    EXPECT_THAT(errorOfText("map:\n  sigma_m: 0.1\n bad: 2\n"),
                AllOf(HasSubstr(".yaml:3:"), HasSubstr("no valid YAML")));
    EXPECT_THAT(errorOfText("map: {sigma_m: 0.1\n"), HasSubstr(".yaml:"));
    EXPECT_THAT(errorOfText("map:\n\tsigma_m: 0.1\n"), HasSubstr(".yaml:2:"));
    EXPECT_THAT(errorOfText("map: 'open\n"), HasSubstr(".yaml:"));
    EXPECT_THAT(errorOfText("map: *nowhere\n"), HasSubstr(".yaml:1:"));
}

TEST(ApplySetting, setsOneParameter) {
    Config config;
    applySetting(config, "vertical.max_tilt_deg=4");
    applySetting(config, " orphan.remove = true ");
    EXPECT_DOUBLE_EQ(config.reduction.vertical.maxTilt, mrpt::DEG2RAD(4.0));
    EXPECT_TRUE(config.reduction.orphan.remove);
}

TEST(ApplySetting, mistakeIsNamedAndChangesNothing) {
    Config config;
    EXPECT_THAT(errorOf([&] { applySetting(config, "map.sigma_m"); }), HasSubstr("key=value"));
    EXPECT_THAT(errorOf([&] { applySetting(config, "map.sigma=1"); }),
                HasSubstr("did you mean map.sigma_m?"));
    EXPECT_THAT(errorOf([&] { applySetting(config, "map.sigma_m=-1"); }), HasSubstr("0 ... 10 m"));
    EXPECT_THAT(errorOf([&] { applySetting(config, "map.sigma_m="); }), HasSubstr("0 ... 10 m"));
    EXPECT_THAT(errorOf([&] { applySetting(config, "map.sigma_m=1=2"); }), HasSubstr("1=2"));
    EXPECT_THAT(errorOf([&] { applySetting(config, ""); }), HasSubstr("key=value"));
    EXPECT_TRUE(equal(config, Config{}));
}

}  // namespace offmap::rawlog
