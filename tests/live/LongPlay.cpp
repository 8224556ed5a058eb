// SPDX-License-Identifier: BSD-3-Clause
#include "../support/LogFiles.h"
#include "../support/TemporaryFolder.h"
#include "TurnsInMemory.h"

#include <offmap/live/RawlogReplay.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <thread>
#include <unistd.h>
#include <vector>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

/// [MiB] of this program that is in memory.
double residentSet() {
    std::ifstream pages("/proc/self/statm");
    double size = 0, resident = 0;
    pages >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// A log of each class of scans played as fast as it goes, over and over, as somebody watches it
/// who tunes a parameter each second.
class LongPlay : public testing::Test {
 protected:
    LongPlay() {
        test::SimulatedRobot robot;
        test::writeLog(log_, test::secondsOf(robot, 10));
        rawlog::RawlogReader reader(log_);
        survey_ = rawlog::surveyLog(reader, config_, std::numeric_limits<uint64_t>::max(), [] {});
    }

    std::unique_ptr<RawlogReplay> replay() const {
        return std::make_unique<RawlogReplay>(log_, survey_, config_,
                                              std::numeric_limits<double>::infinity(),
                                              RawlogReplay::AtEnd::Wait);
    }

    static void tune(LiveReduction& reduction, int round) {
        LiveSetup setup = test::officeSetup();
        setup.config.reduction.vertical.minLength = round % 2 == 0 ? 0.1 : 0.2;  // [m]
        reduction.change(setup);
    }

    test::TemporaryFolder folder_;
    std::filesystem::path log_ = folder_ / "play.rawlog";
    rawlog::Config config_;
    rawlog::LogSurvey survey_;
};

// What would be lost with each turn is multiplied by thousands of them: 8 MiB, which the allocator
// may keep in pieces, are 300 bytes of each of 30,000 turns.
TEST_F(LongPlay, fiveMinutesTakeNoMoreMemoryThanOne) {
    auto source = replay();
    RawlogReplay& player = *source;
    LiveReduction reduction(std::move(source), test::officeSetup());
    std::vector<double> sizes;  // [MiB] each 10 s
    const auto begin = Steady::now();
    std::printf("   [s]     turns   [MiB]\n");
    for (int second = 1; second <= 300; ++second) {
        while (Steady::now() < begin + second * 1s) {
            if (player.health().state == SourceState::Ended) player.jumpTo(0);
            ASSERT_FALSE(reduction.finished()) << reduction.failure();
            std::this_thread::sleep_for(5ms);
        }
        tune(reduction, second);
        if (second % 10 != 0) continue;
        sizes.push_back(residentSet());
        std::printf("%6d %9ju %7.1f\n", second, uintmax_t(reduction.figures().totals.scans),
                    sizes.back());
        std::fflush(stdout);
    }
    const double early = *std::max_element(sizes.begin(), sizes.begin() + 6);
    const double late = *std::max_element(sizes.end() - 6, sizes.end());
    EXPECT_LE(late, early + 8);
    EXPECT_GT(reduction.figures().totals.scans, 30'000U) << "else the bound says less";
}

}  // namespace
}  // namespace offmap::live
