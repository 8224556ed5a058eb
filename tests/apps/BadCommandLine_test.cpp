// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadCommandLine : public ReduceFixture {
 protected:
    BadCommandLine() { writeLog(in_, smallLog()); }

    template <class Matcher>
    void expectRefused(const Arguments& more, const Matcher& message) const {
        expectRefusal(reduceArguments(more), 1, message);
    }
};

TEST_F(BadCommandLine, noArgumentsTellTheSubcommands) {
    expectRefusal({}, 1, AllOf(HasSubstr("subcommand"), HasSubstr("--help")));
}

TEST_F(BadCommandLine, unknownSubcommandIsRefused) {
    expectRefusal({"shrink", in_}, 1, AllOf(HasSubstr("shrink"), HasSubstr("--help")));
}

TEST_F(BadCommandLine, missingOptionIsNamed) {
    expectRefusal({"reduce", in_, "-o", out_}, 1, HasSubstr("--map is required"));
    expectRefusal({"reduce", in_, "--map", map_}, 1, HasSubstr("--out is required"));
    expectRefusal({"reduce", "--map", map_, "-o", out_}, 1, HasSubstr("IN is required"));
}

TEST_F(BadCommandLine, unknownOptionIsNamed) { expectRefused({"--stirct"}, HasSubstr("--stirct")); }

TEST_F(BadCommandLine, unknownOutputClassIsRefused) {
    expectRefused({"--output", "pcd"}, AllOf(HasSubstr("pcd"), HasSubstr("points")));
}

TEST_F(BadCommandLine, unknownMethodListsTheKnownOnes) {
    expectRefused({"--method", "magic"}, AllOf(HasSubstr("magic"), HasSubstr("paper")));
}

TEST_F(BadCommandLine, unknownKeyInConfigurationTellsTheLine) {
    const Path config = folder_ / "own.yaml";
    writeFile(config, "vertical:\n  max_tilt_deg: 4\n  max_titl_deg: 5\n");
    expectRefused({"--config", config},
                  AllOf(HasSubstr(config.string()), HasSubstr("vertical.max_titl_deg")));
}

TEST_F(BadCommandLine, missingConfigurationIsNamed) {
    const Path config = folder_ / "missing.yaml";
    expectRefused({"--config", config}, HasSubstr(config.string()));
}

TEST_F(BadCommandLine, badSettingIsNamed) {
    expectRefused({"--set", "vertical.max_tilt=4"}, HasSubstr("vertical.max_tilt"));
    expectRefused({"--set", "vertical.max_tilt_deg=steep"}, HasSubstr("vertical.max_tilt_deg"));
    expectRefused({"--set", "vertical.max_tilt_deg=-4"}, HasSubstr("vertical.max_tilt_deg"));
    expectRefused({"--set", "vertical.max_tilt_deg"}, HasSubstr("vertical.max_tilt_deg"));
    expectRefused({"--set", "matching.sigma_factor=nan"}, HasSubstr("matching.sigma_factor"));
}

TEST_F(BadCommandLine, outputMayNotBeTheInput) {
    out_ = in_;
    expectRefused({}, AllOf(HasSubstr("IN and OUT are the same file"), HasSubstr(in_.string())));
    expectRefused({"--force"}, HasSubstr("IN and OUT are the same file"));
    out_ = folder_.path() / "." / "in.rawlog";
    expectRefused({"--force"}, HasSubstr("IN and OUT are the same file"));
    out_ = folder_ / "link.rawlog";
    std::filesystem::create_symlink(in_, out_);
    expectRefused({"--force"}, HasSubstr("IN and OUT are the same file"));
    std::filesystem::remove(out_);
    std::filesystem::create_hard_link(in_, out_);
    expectRefused({"--force"}, HasSubstr("IN and OUT are the same file"));
}

TEST_F(BadCommandLine, outputsMayNotBeEachOther) {
    expectRefused({"--removed", out_}, HasSubstr("OUT and --removed are the same file"));
    expectRefused({"--report", out_}, HasSubstr("OUT and --report are the same file"));
    expectRefused({"--segments", out_}, HasSubstr("OUT and --segments are the same file"));
    const Path report = folder_ / "report";
    expectRefused({"--report", report, "--segments", report},
                  HasSubstr("--report and --segments are the same file"));
    expectRefused({"--removed", in_, "--force"}, HasSubstr("IN and --removed are the same file"));
    expectRefused({"--report", map_, "--force"}, HasSubstr("--map and --report are the same file"));
}

TEST_F(BadCommandLine, sigmaWithoutFixedPoseIsRefused) {
    expectRefused({"--pose-sigma", "0.1,1"}, HasSubstr("--pose"));
}

TEST_F(BadCommandLine, poseAndLabelExcludeEachOther) {
    expectRefused({"--pose", "0,0,0", "--pose-label", "AMCL"}, HasSubstr("excludes"));
}

TEST(CommandLine, helpNamesEveryOption) {
    const RunResult all = runOffmap({"--help"});
    EXPECT_EQ(all.exitCode, 0);
    EXPECT_THAT(all.out, AllOf(HasSubstr("reduce"), HasSubstr("render"), HasSubstr("live"),
                               HasSubstr("--version")));
    const RunResult reduce = runOffmap({"reduce", "--help"});
    EXPECT_EQ(reduce.exitCode, 0);
    EXPECT_EQ(reduce.err, "");
    for (const char* option :
         {"IN",        "--map",        "-o",           "--removed",     "--report", "--segments",
          "--inspect", "--method",     "--config",     "--set",         "--sensor", "--pose-label",
          "--pose ",   "--pose-sigma", "--map-origin", "--sensor-pose", "--output", "same",
          "points",    "--strict",     "--keep-going", "--force",       "--quiet",  "Exit codes"}) {
        EXPECT_THAT(reduce.out, HasSubstr(option));
    }
    const RunResult render = runOffmap({"render", "--help"});
    EXPECT_EQ(render.exitCode, 0);
    EXPECT_THAT(render.out, AllOf(HasSubstr("--entry"), HasSubstr("--force")));
}

TEST(CommandLine, versionIsTold) {
    const RunResult run = runOffmap({"--version"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, testing::MatchesRegex("offmap [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(BadCommandLine, quietRunSaysNothing) {
    const RunResult run = reduce({"--quiet"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.out + run.err, "");
}

}  // namespace
