// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/StageTimes.h>

#include <ctime>

namespace offmap::rawlog {
namespace {

int64_t workedByThread() {  // [ns]
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return int64_t{1'000'000'000} * worked.tv_sec + worked.tv_nsec;
}

}  // namespace

StageTimes::Measure::Measure(StageTimes& times, Stage stage)
    : total_(times.nanoseconds_[stage]), begin_(workedByThread()) {}

StageTimes::Measure::~Measure() { total_ += workedByThread() - begin_; }

}  // namespace offmap::rawlog
