// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/RawlogReader.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace offmap::rawlog;
using Kind = GuardedOutcome::Kind;
using offmap::test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;

[[noreturn]] void waitForever() {
    for (;;) pause();
}

TEST(GuardedRun, givesTheExitCodeOfTheWork) {
    for (int code : {0, 1, 3}) {
        const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) {
            status.atEntry({7, 4096});
            return code;
        });
        EXPECT_EQ(outcome.kind, Kind::Finished);
        EXPECT_EQ(outcome.exitCode, code);
        EXPECT_EQ(outcome.place, (EntryPlace{7, 4096}));
    }
}

TEST(GuardedRun, crashTellsTheEntryAndLeavesNoTemporaryFile) {
    const TemporaryFolder folder;
    const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) -> int {
        OutputFile published(folder / "published", {.temporaries = &status});
        published.publish();
        OutputFile output(folder / "output", {.temporaries = &status});
        output.write("half of it");
        status.atEntry({412, 1'234'567});
        std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would turn the crash into an exit
        std::raise(SIGSEGV);
        return 0;
    });
    EXPECT_EQ(outcome.kind, Kind::Died);
    EXPECT_EQ(outcome.signal, SIGSEGV);
    EXPECT_EQ(outcome.place, (EntryPlace{412, 1'234'567}));
    EXPECT_THAT(outcome.cause, HasSubstr("crashed: Segmentation fault"));
    EXPECT_THAT(folder.names(), testing::ElementsAre("published"));
}

TEST(GuardedRun, exitOfALibraryIsNoResult) {
    const TemporaryFolder folder;
    const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) -> int {
        const OutputFile output(folder / "output", {.temporaries = &status});
        std::exit(1);
    });
    EXPECT_EQ(outcome.kind, Kind::Died);
    EXPECT_THAT(outcome.cause, HasSubstr("exit code 1"));
    EXPECT_EQ(outcome.place, std::nullopt);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(GuardedRun, exceptionIsTold) {
    const GuardedOutcome outcome = runGuarded(
        [](GuardedStatus&) -> int { throw std::runtime_error("the map is upside down"); });
    EXPECT_EQ(outcome.kind, Kind::Died);
    EXPECT_EQ(outcome.cause, "the map is upside down");
}

TEST(GuardedRun, absurdAllocationDies) {
    const GuardedOutcome outcome = runGuarded([](GuardedStatus&) {
        const std::vector<char> absurd(100'000'000'000);
        return static_cast<int>(absurd[absurd.size() / 2]);
    });
    EXPECT_EQ(outcome.kind, Kind::Died);
}

TEST(GuardedRun, endlessRecursionOfTheDeserialiserDies) {
    // A sensory frame that holds a sensory frame that holds ...: class name, version, count.
    const std::string frame(
        "\x8d"
        "CSensoryFrame"
        "\x02"
        "\x01\0\0\0",
        19);
    const TemporaryFolder folder;
    std::string content;
    for (int i = 0; i < 200'000; ++i) content += frame;
    offmap::test::writeFile(folder / "x.rawlog", content);
    const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) {
        RawlogReader reader(folder / "x.rawlog");
        status.atEntry(reader.place());
        reader.next();
        return 0;
    });
    EXPECT_EQ(outcome.kind, Kind::Died);
    EXPECT_EQ(outcome.place, EntryPlace{});
    EXPECT_THAT(outcome.cause, testing::Not(HasSubstr("x.rawlog")));  // not caught by the reader
}

TEST(GuardedRun, interruptionEndsTheWorkAndLeavesNoFile) {
    for (int number : {SIGINT, SIGTERM, SIGHUP}) {
        const TemporaryFolder folder;
        const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) -> int {
            const OutputFile output(folder / "output", {.temporaries = &status});
            kill(getppid(), number);
            waitForever();
        });
        EXPECT_EQ(outcome.kind, Kind::Interrupted);
        EXPECT_EQ(outcome.signal, number);
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

TEST(GuardedRun, interruptionWaitsForPublishing) {
    const TemporaryFolder folder;
    const GuardedOutcome outcome = runGuarded([&](GuardedStatus& status) {
        OutputFile output(folder / "output", {.temporaries = &status});
        status.beginPublishing();
        kill(getppid(), SIGINT);
        usleep(100'000);  // time for the watcher to do wrong
        output.publish();
        return 0;
    });
    EXPECT_EQ(outcome.kind, Kind::Finished);
    EXPECT_EQ(outcome.signal, SIGINT) << "whoever has more to do must know";
    EXPECT_THAT(folder.names(), testing::ElementsAre("output"));
}

TEST(GuardedRun, secondInterruptionEndsEvenPublishing) {
    const GuardedOutcome outcome = runGuarded([](GuardedStatus& status) -> int {
        status.beginPublishing();
        kill(getppid(), SIGINT);
        usleep(100'000);  // equal signals that wait are one
        kill(getppid(), SIGINT);
        waitForever();
    });
    EXPECT_EQ(outcome.kind, Kind::Interrupted);
}

TEST(GuardedRun, ignoredSignalStaysIgnored) {
    const auto before = std::signal(SIGHUP, SIG_IGN);
    const GuardedOutcome outcome = runGuarded([](GuardedStatus&) {
        kill(getppid(), SIGHUP);
        usleep(100'000);  // time for the watcher to do wrong
        return 5;
    });
    std::signal(SIGHUP, before);
    EXPECT_EQ(outcome.kind, Kind::Finished);
    EXPECT_EQ(outcome.exitCode, 5);
}

TEST(GuardedRun, restoresSignals) {
    sigset_t before, after;
    sigprocmask(SIG_BLOCK, nullptr, &before);
    const auto handler = std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(runGuarded([](GuardedStatus&) { return 4; }).exitCode, 4);
    EXPECT_EQ(std::signal(SIGCHLD, handler), SIG_IGN);
    sigprocmask(SIG_BLOCK, nullptr, &after);
    for (int number : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
        EXPECT_EQ(sigismember(&before, number), sigismember(&after, number)) << number;
    }
}

TEST(GuardedRun, workLeavesNoCoreFile) {
    const GuardedOutcome outcome = runGuarded([](GuardedStatus&) {
        rlimit core{};
        getrlimit(RLIMIT_CORE, &core);
        return core.rlim_cur == 0 ? 0 : 1;
    });
    EXPECT_EQ(outcome.exitCode, 0);
}

}  // namespace
