// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/StageTimes.h>

#include <gtest/gtest.h>

#include <ctime>
#include <thread>

namespace {

using offmap::rawlog::StageTimes;
using Measure = StageTimes::Measure;

double workedByThread() {  // [s]
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return static_cast<double>(worked.tv_sec) + 1e-9 * static_cast<double>(worked.tv_nsec);
}

void work(double seconds) {
    const double begin = workedByThread();
    while (workedByThread() - begin < seconds) {
    }
}

TEST(StageTimes, countNothingTwice) {
    StageTimes times;
    const double begin = workedByThread();
    {
        const Measure read(times, StageTimes::Read);
        work(0.004);
        {
            const Measure unpack(times, StageTimes::Unpack);
            work(0.008);
        }
        work(0.002);
    }
    const double all = workedByThread() - begin;
    const double read = times.seconds(StageTimes::Read), unpack = times.seconds(StageTimes::Unpack);
    EXPECT_GE(read, 0.006);
    EXPECT_GE(unpack, 0.008);
    EXPECT_LE(read + unpack, all);
}

TEST(StageTimes, addWhatThreadsWorkNotHowLongTheyWait) {
    StageTimes times;
    const auto packSome = [&] {
        const Measure pack(times, StageTimes::Pack);
        work(0.003);
    };
    std::thread other(packSome);
    {
        const Measure write(times, StageTimes::Write);
        other.join();
    }
    packSome();
    EXPECT_GE(times.seconds(StageTimes::Pack), 0.006);
    EXPECT_LT(times.seconds(StageTimes::Write), 0.003);  // a call that waits costs microseconds
    EXPECT_EQ(times.seconds(StageTimes::Survey), 0);
}

}  // namespace
