// SPDX-License-Identifier: BSD-3-Clause
#include "FreePort.h"
#include "ReduceFixture.h"

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <csignal>
#include <regex>
#include <thread>

namespace offmap::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

/// A VLP-16 that another program plays, and `offmap live` that listens to it.
class LiveNetwork : public ReduceFixture {
 protected:
    Arguments liveCommand(const Arguments& more = {}) const {
        Arguments all{offmapBinary(),
                      "live",
                      "udp:" + std::to_string(port_),
                      "--map",
                      sourceFile("share/maps/vlp16_demo.lines"),
                      "--config",
                      "vlp16",
                      "--pose",
                      "0,0,0"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Arguments senderCommand(const std::string& factor, const std::string& seconds) const {
        return {offmapBinary().parent_path() / "offmap_velodyne_sender",
                "--port",
                std::to_string(port_),
                "--factor",
                factor,
                "--seconds",
                seconds};
    }

    /// Lets it take what has come, and reads what it says at the end.
    static RunResult ended(RunningProgram& live) {
        std::this_thread::sleep_for(1500ms);  // more than the 500 ms after which silence is told
        kill(live.id(), SIGTERM);
        return live.wait();
    }

    /// The number that follows, or stands before, a word.
    static uint64_t numberIn(const std::string& text, const std::string& pattern) {
        std::smatch match;
        if (!std::regex_search(text, match, std::regex(pattern))) return 0;
        std::string digits = match[1];
        std::erase(digits, ',');
        return std::stoull(digits);
    }
    static uint64_t scans(const RunResult& run) { return numberIn(run.out, "scans +([0-9,]+)"); }
    static uint64_t points(const RunResult& run) { return numberIn(run.out, "points +([0-9,]+)"); }
    static uint64_t dropped(const RunResult& run) {
        return numberIn(run.out, "dropped +([0-9,]+)");
    }
    static uint64_t came(const RunResult& run) {
        return numberIn(run.out, "of ([0-9,]+) that came");
    }
    static uint64_t missing(const RunResult& run) {
        return numberIn(run.out, "missing +([0-9,]+)");
    }

    uint16_t port_ = freeUdpPort();
};

// A machine that does other things at the same time may hold up the program, but a second's turns
// may wait, and a second's packets.
TEST_F(LiveNetwork, everyReturnOfEveryTurnIsReduced) {
    const Path recorded = folder_ / "recorded.rawlog";
    RunningProgram live(liveCommand({"--waiting", "20", "--record", recorded}));
    ASSERT_TRUE(waitUntilListened(port_, live));
    const RunResult sent = runProgram(senderCommand("1", "10"));
    ASSERT_EQ(sent.exitCode, 0) << sent.err;
    const RunResult run = ended(live);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(points(run), numberIn(sent.out, "returns ([0-9]+)"));
    EXPECT_EQ(scans(run), numberIn(sent.out, "turns ([0-9]+)"));
    EXPECT_EQ(came(run), scans(run));
    EXPECT_EQ(dropped(run), 0U);
    EXPECT_EQ(missing(run), 0U) << run.out;
    uint64_t packets = 0;
    std::vector<size_t> perTurn;
    for (const auto& obs : observationsOf(recorded)) {
        using Scan = mrpt::obs::CObservationVelodyneScan;
        const auto scan = std::dynamic_pointer_cast<Scan>(obs);
        if (!scan) continue;
        perTurn.push_back(scan->scan_packets.size());
        packets += perTurn.back();
    }
    EXPECT_EQ(packets, numberIn(sent.out, "packets ([0-9]+)"));
    ASSERT_GT(perTurn.size(), 90U) << "of 99.5 ms";
    for (size_t i = 1; i + 1 < perTurn.size(); ++i) EXPECT_EQ(perTurn[i], 75U) << i;
}

TEST_F(LiveNetwork, tenTimesAsFastNothingIsLostWithoutAWord) {
    RunningProgram live(liveCommand());
    ASSERT_TRUE(waitUntilListened(port_, live));
    const RunResult sent = runProgram(senderCommand("10", "2"));
    const RunResult run = ended(live);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_GT(scans(run), 0U);
    EXPECT_EQ(scans(run) + dropped(run), came(run));
    if (missing(run) == 0) {
        EXPECT_EQ(came(run), numberIn(sent.out, "turns ([0-9]+)"));
    } else {
        EXPECT_LE(points(run), numberIn(sent.out, "returns ([0-9]+)"));
    }
}

TEST_F(LiveNetwork, aSenderThatDiesAndComesBackIsGoneOnWith) {
    RunningProgram live(liveCommand({"--waiting", "20"}));
    ASSERT_TRUE(waitUntilListened(port_, live));
    {
        RunningProgram sender(senderCommand("1", "60"));
        std::this_thread::sleep_for(1500ms);
        kill(sender.id(), SIGKILL);
        sender.wait();
    }
    // A line a second tells how it is, from half a second after the last packet on.
    std::this_thread::sleep_for(2500ms);
    const RunResult sent = runProgram(senderCommand("1", "2"));
    const RunResult run = ended(live);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("stalled: no packets come"));
    EXPECT_GE(numberIn(run.out, "stalled +([0-9]+)"), 2U) << "and at the end once more";
    EXPECT_GT(scans(run), numberIn(sent.out, "turns ([0-9]+)"));
    EXPECT_GT(points(run), numberIn(sent.out, "returns ([0-9]+)"));
    EXPECT_EQ(missing(run), 0U) << "what was not sent is not missing";
}

}  // namespace
}  // namespace offmap::test
