// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadOutput : public ReduceFixture {
 protected:
    BadOutput() { writeLog(in_, smallLog()); }
};

TEST_F(BadOutput, missingFolderIsNotCreated) {
    out_ = folder_ / "reduced" / "out.rawlog";
    expectRefusal(
        reduceArguments(), 2,
        AllOf(HasSubstr("cannot write " + out_.string()), HasSubstr("create its folder first")));
}

TEST_F(BadOutput, folderIsNoFile) {
    for (const char* option : {"--removed", "--report", "--segments", "--inspect"}) {
        expectRefusal(reduceArguments({option, folder_.path(), "--force"}), 2,
                      HasSubstr("it is a folder"));
    }
}

TEST_F(BadOutput, existingFileNeedsForce) {
    writeFile(out_, "yesterday's result");
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("cannot write " + out_.string()), HasSubstr("exists already"),
                        HasSubstr("--force")));
    EXPECT_EQ(reduce({"--force"}).exitCode, 0);
    EXPECT_EQ(entriesOf(out_).size(), 3U);
}

TEST_F(BadOutput, otherExistingFilesNeedForceToo) {
    const Path other = folder_ / "other";
    writeFile(other, "yesterday's result");
    for (const char* option : {"--removed", "--report", "--segments", "--inspect"}) {
        expectRefusal(reduceArguments({option, other}), 2,
                      AllOf(HasSubstr(other.string()), HasSubstr("--force")));
    }
}

TEST_F(BadOutput, failureWithForceKeepsTheOldFile) {
    writeFile(out_, "yesterday's result");
    writeFile(in_, readFile(in_).substr(0, 300));
    expectRefusal(reduceArguments({"--force"}), 2, HasSubstr(in_.string()));
}

TEST_F(BadOutput, folderThatIsNotWritableIsNamed) {
    const Path locked = folder_ / "locked";
    std::filesystem::create_directory(locked);
    std::filesystem::permissions(locked, std::filesystem::perms(0555));
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
    out_ = locked / "out.rawlog";
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("cannot write " + out_.string()), HasSubstr("Permission denied"),
                        HasSubstr("make its folder writable")),
                  {.user = unprivileged()});
}

TEST_F(BadOutput, limitOfTheFileSizeIsNamed) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    for (const rlim_t bytes : {0, 1000, 30'000}) {
        SCOPED_TRACE(bytes);
        expectRefusal(reduceArguments({"--quiet", "--removed", folder_ / "removed.rawlog"}), 2,
                      AllOf(HasSubstr("cannot write " + folder_.path().string()),
                            HasSubstr("File too large"), HasSubstr("ulimit -f")),
                      {.limits = {{RLIMIT_FSIZE, bytes}}});
    }
}

// `offmap reduce ... | head -1` must not cost the result.
TEST_F(BadOutput, brokenPipeDoesNotStopTheWork) {
    ASSERT_EQ(reduce().exitCode, 0);
    const std::string result = readFile(out_);
    EXPECT_EQ(reduce({"--force"}, {.nobodyListens = true}).exitCode, 0);
    EXPECT_TRUE(readFile(out_) == result);
    out_ = folder_ / "missing" / "out.rawlog";
    EXPECT_EQ(reduce({}, {.nobodyListens = true}).exitCode, 2);
}

// `offmap reduce ... >&- 2>&-`: the next file that is opened must not stand for stdout.
TEST_F(BadOutput, closedStreamsDoNotSpoilTheResult) {
    ASSERT_EQ(reduce().exitCode, 0);
    const std::string result = readFile(out_);
    Arguments command{"/bin/sh", "-c", "\"$0\" \"$@\" --force <&- >&- 2>&-", offmapBinary()};
    const Arguments arguments = reduceArguments();
    command.insert(command.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(runProgram(command).exitCode, 0);
    EXPECT_TRUE(readFile(out_) == result);
}

// A disk that nobody else sees, in a mount namespace of its own. Where mounting is not allowed, the
// limit of the file size has to stand for it.
TEST_F(BadOutput, fullDiskIsNamed) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    const Path disk = folder_ / "disk";
    std::filesystem::create_directory(disk);
    out_ = disk / "out.rawlog";
    constexpr int notAllowed = 99;
    Arguments command{"/usr/bin/unshare",
                      geteuid() == 0 ? "-m" : "-Urm",
                      "/bin/sh",
                      "-c",
                      "mount -t tmpfs -o size=48k none \"$0\" || exit 99\n"
                      "\"$@\"; code=$?; echo left: $(ls -A \"$0\"); exit $code",
                      disk,
                      offmapBinary()};
    const Arguments arguments = reduceArguments();
    command.insert(command.end(), arguments.begin(), arguments.end());
    const RunResult run = runProgram(command);
    if (run.exitCode == notAllowed || run.err.starts_with("unshare:")) return;
    EXPECT_EQ(run.exitCode, 2) << testing::PrintToString(run);
    EXPECT_THAT(run.err,
                AllOf(HasSubstr("cannot write " + out_.string()),
                      HasSubstr("No space left on device"), HasSubstr("free space on that disk")));
    EXPECT_THAT(run.out, HasSubstr("left:\n")) << "a file stayed on the full disk";
}

}  // namespace
