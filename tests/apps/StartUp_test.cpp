// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StartUp : public ReduceFixture {};

// Loading MRPT's drivers, and with them libraries of windows and videos, takes a fifth of a second.
TEST_F(StartUp, loadsNoDrivers) {
    const RunResult run = runProgram({"/usr/bin/env", "LD_TRACE_LOADED_OBJECTS=1", offmapBinary()});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, AllOf(HasSubstr("libmrpt-obs"), Not(HasSubstr("libmrpt-hwdrivers")),
                               Not(HasSubstr("libwx"))));
}

TEST_F(StartUp, ofLiveTakesItsOwnOptions) {
    const RunResult help = runOffmap({"live", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.out, AllOf(HasSubstr("Usage: offmap live"), HasSubstr("SOURCE"),
                                HasSubstr("--record"), HasSubstr("Ctrl-C ends it")));
    EXPECT_THAT(runOffmap({"--help"}).out, HasSubstr("live"));
    expectRefusal({"live", "udp", "--map", map_, "--sped", "2"}, 1,
                  AllOf(HasSubstr("--sped"), HasSubstr("offmap live --help")));
}

TEST_F(StartUp, ofLiveNamesTheProgramThatIsMissing) {
    const Path alone = folder_ / "offmap";
    std::filesystem::copy_file(offmapBinary(), alone);
    const RunResult run = runProgram({alone, "live", "udp"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err,
                AllOf(HasSubstr("offmap: cannot run " + (folder_ / "offmap-live").string()),
                      HasSubstr("install all of offmap's programs")));
}

}  // namespace
