// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/ReplayClock.h>

#include <gtest/gtest.h>

#include <limits>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;

const ReplayClock::SteadyTime start{1000s};
const auto logStart = mrpt::Clock::fromDouble(1.7e9);

TEST(ReplayClock, theFirstTimeIsDueAtOnce) {
    ReplayClock clock(1);
    EXPECT_EQ(clock.due(logStart, start), start);
}

TEST(ReplayClock, laterTimesAreDueByTheSpeed) {
    ReplayClock clock(10);
    clock.due(logStart, start);
    EXPECT_EQ(clock.due(logStart + 5s, start + 1ms), start + 500ms);
    EXPECT_EQ(clock.due(logStart + 20s, start + 1ms), start + 2s);
}

TEST(ReplayClock, aChangeOfSpeedHoldsFromThenOn) {
    ReplayClock clock(1);
    clock.due(logStart, start);
    clock.setSpeed(0.1, start + 2s);
    EXPECT_EQ(clock.due(logStart + 3s, start + 2s), start + 2s + 10s);
}

TEST(ReplayClock, nothingIsDueInAPauseWhichDelaysTheRest) {
    ReplayClock clock(1);
    clock.due(logStart, start);
    clock.pause(start + 1s);
    EXPECT_EQ(clock.due(logStart + 3s, start + 50s), std::nullopt);
    clock.resume(start + 60s);
    EXPECT_EQ(clock.due(logStart + 3s, start + 60s), start + 62s);
}

TEST(ReplayClock, infiniteSpeedWaitsForNothing) {
    ReplayClock clock(std::numeric_limits<double>::infinity());
    clock.due(logStart, start);
    EXPECT_EQ(clock.due(logStart + 500s, start + 1s), start + 1s);
    clock.setSpeed(1, start + 2s);
    EXPECT_EQ(clock.due(logStart + 503s, start + 2s), start + 5s) << "3 s after the last";
}

TEST(ReplayClock, aLogThatJumpsBackGoesOnAtOnce) {
    ReplayClock clock(1);
    clock.due(logStart + 100s, start);
    EXPECT_EQ(clock.due(logStart, start + 1s), start + 1s);
    EXPECT_EQ(clock.due(logStart + 2s, start + 1s), start + 3s);
}

TEST(ReplayClock, speedsThatAreNoneAreRefused) {
    for (const double speed : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(ReplayClock{speed}, std::invalid_argument);
}

}  // namespace
}  // namespace offmap::live
