// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace offmap::test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

/// `offmap live --follow` of a log that another program writes bit by bit.
class LiveFollow : public ReduceFixture, public testing::WithParamInterface<bool> {
 protected:
    LiveFollow() {
        SimulatedRobot robot;
        Observations log;
        for (int i = 0; i < 6; ++i) {
            log.push_back(robot.localisation());
            log.push_back(robot.cloud("CLOUD", 40));
            robot.wait(0.1);
        }
        const bool gzip = GetParam();
        writeLog(whole_, log, gzip ? std::optional<int>(1) : std::nullopt);
        writeFile(in_, "");
    }

    /// Writes so many bytes of the log, 3000 at a time; then it hangs until it is killed.
    Arguments writer(size_t bytes) const {
        constexpr const char* script =
            "at=0; while [ $at -lt $3 ]; do size=$(($3 - at)); [ $size -le 3000 ] || size=3000; "
            "tail -c +$((at + 1)) \"$1\" | head -c $size >> \"$2\"; at=$((at + size)); "
            "sleep 0.02; done; exec sleep 600";
        return {"/bin/sh", "-c", script, "sh", whole_, in_, std::to_string(bytes)};
    }

    void killInTheMiddleOfAnEntry() const {
        const size_t bytes = std::filesystem::file_size(whole_) - 1000;  // inside the last cloud
        RunningProgram writing(writer(bytes));
        while (std::filesystem::file_size(in_) < bytes && writing.runs())
            std::this_thread::sleep_for(5ms);
        kill(writing.id(), SIGKILL);
        EXPECT_EQ(writing.wait().exitCode, 128 + SIGKILL);
    }

    Path whole_ = folder_ / "whole.rawlog";
};

TEST_P(LiveFollow, outlivesTheProgramThatWritesTheLog) {
    RunningProgram live({offmapBinary(), "live", in_, "--follow", "--map", map_});
    killInTheMiddleOfAnEntry();
    // It tells of silence after two seconds, once a second.
    std::this_thread::sleep_for(4s);
    EXPECT_TRUE(live.runs());
    kill(live.id(), SIGTERM);
    const RunResult run = live.wait();
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("stalled: " + in_.string() + " does not grow"));
    EXPECT_THAT(run.out, AllOf(HasSubstr("of 5 that came"), HasSubstr("stalled")))
        << "the last one was cut short";
}

INSTANTIATE_TEST_SUITE_P(AsWritten, LiveFollow, testing::Bool(), [](const auto& written) {
    return std::string(written.param ? "gzip" : "plain");
});

}  // namespace
}  // namespace offmap::test
