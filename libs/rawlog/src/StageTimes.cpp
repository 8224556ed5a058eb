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

thread_local StageTimes::Measure* innermost = nullptr;

}  // namespace

StageTimes::Measure::Measure(StageTimes& times, Stage stage)
    : total_(times.nanoseconds_[stage]), outer_(innermost) {
    if (outer_) outer_->pause();
    innermost = this;
    begin_ = workedByThread();
}

StageTimes::Measure::~Measure() {
    pause();
    innermost = outer_;
    if (outer_) outer_->begin_ = workedByThread();
}

void StageTimes::Measure::pause() { total_ += workedByThread() - begin_; }

}  // namespace offmap::rawlog
