// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;

// What a wall of the office leaves after the default's reduction, each preset must find as well.
TEST_F(ReduceFixture, everyPresetReducesTheOffice) {
    SimulatedRobot robot;
    writeLog(in_, oneSecondOf(robot));
    const auto report = folder_ / "report.json";
    for (const char* preset : {"default", "indoor", "outdoor", "vlp16", "hdl32", "depth_camera"}) {
        SCOPED_TRACE(preset);
        const auto file = sourceFile("config") / (std::string(preset) + ".yaml");
        const RunResult run = reduce({"--config", file, "--report", report, "--force"});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(run.err, "");
        const auto totals = nlohmann::json::parse(readFile(report))["totals"];
        // The office's objects and the room behind the door hold less than half of all.
        EXPECT_GT(totals["points_removed"].get<double>(),
                  0.5 * totals["points_on_vertical_segments"].get<double>());
    }
}

TEST_F(ReduceFixture, defaultPresetIsWhatHoldsWithoutOne) {
    SimulatedRobot robot;
    writeLog(in_, oneSecondOf(robot));
    ASSERT_EQ(reduce().exitCode, 0);
    const std::string without = readFile(out_);
    ASSERT_EQ(reduce({"--config", sourceFile("config/default.yaml"), "--force"}).exitCode, 0);
    EXPECT_TRUE(readFile(out_) == without);
}

TEST_F(ReduceFixture, presetGoesByItsName) {
    writeLog(in_, smallLog());
    const auto report = folder_ / "report.json";
    for (const auto& file : std::filesystem::directory_iterator(sourceFile("config"))) {
        const std::string name = file.path().stem();
        SCOPED_TRACE(name);
        const auto parametersWith = [&](const std::string& config) {
            const RunResult run = reduce({"--config", config, "--report", report, "--force"});
            EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
            return nlohmann::json::parse(readFile(report))["parameters"];
        };
        EXPECT_EQ(parametersWith(name), parametersWith(file.path()));
    }
}

TEST_F(ReduceFixture, presetIsFoundBesideTheProgramAsInstalled) {
    std::filesystem::create_directories(folder_ / "usr/bin");
    std::filesystem::create_directories(folder_ / "usr/share/offmap/config");
    const Path program = folder_ / "usr/bin/offmap";
    std::filesystem::copy_file(offmapBinary(), program);
    writeLog(in_, smallLog());
    std::vector<std::string> arguments = reduceArguments({"--config", "own"});
    arguments.insert(arguments.begin(), program);
    RunResult run = runProgram(arguments);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, testing::HasSubstr("no preset beside this program"));

    writeFile(folder_ / "usr/share/offmap/config/default.yaml", "{}\n");
    writeFile(folder_ / "usr/share/offmap/config/own.yaml", "map: {sigma_m: 0.07}\n");
    run = runProgram(arguments);
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
}

TEST_F(ReduceFixture, unknownPresetListsThoseThereAre) {
    writeLog(in_, smallLog());
    for (const char* name : {"vlp17", "VLP16", "."}) {
        expectRefusal(reduceArguments({"--config", name}), 1,
                      testing::AllOf(testing::HasSubstr(std::string("'") + name + "'"),
                                     testing::HasSubstr("default, ")));
    }
    // With a folder or an extension, it is a file.
    for (const char* file : {"./vlp16", "vlp16.yaml"}) {
        expectRefusal(reduceArguments({"--config", file}), 1,
                      testing::AllOf(testing::HasSubstr(file), testing::HasSubstr("cannot be")));
    }
    expectRefusal(reduceArguments({"--config", ""}), 1, testing::HasSubstr("--config"));
}

TEST_F(ReduceFixture, fileOfThatNameGoesBeforeThePreset) {
    writeLog(in_, smallLog());
    writeFile(folder_ / "vlp16", "mistake: {a: 1}\n");
    RunOptions here;
    here.folder = folder_.path();
    EXPECT_THAT(reduce({"--config", "vlp16"}, here).err, testing::HasSubstr("mistake"));
}

}  // namespace
