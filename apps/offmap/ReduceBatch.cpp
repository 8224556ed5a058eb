// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceBatch.h"

#include "ReduceGuarded.h"
#include "SummaryText.h"
#include "input/Console.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>

namespace offmap::app {

namespace {

/// Interruptions wait for the next log, whose watcher ends it: none is lost between two logs.
class InterruptionsHeld {
 public:
    InterruptionsHeld() {
        sigset_t held;
        sigemptyset(&held);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, number);
        sigprocmask(SIG_BLOCK, &held, &before_);
    }
    ~InterruptionsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    InterruptionsHeld(const InterruptionsHeld&) = delete;
    InterruptionsHeld& operator=(const InterruptionsHeld&) = delete;

 private:
    sigset_t before_{};
};

/// What has come of the logs so far.
struct BatchResult {
    rawlog::ReductionTotals totals;
    std::vector<std::string> lines;  ///< of the summary, one a log
    size_t done = 0;                 ///< logs whose outputs are there
    uint64_t bytesBefore = 0, bytesAfter = 0;
    int exitCode = exitDone;
    int interruption = 0;  ///< signal that ended the work
};

int worse(int a, int b) {
    constexpr std::array order{exitDone, exitUsage, exitNotReduced, exitFailed};
    return std::max(a, b, [&](int x, int y) {
        return std::ranges::find(order, x) < std::ranges::find(order, y);
    });
}

void addReduced(const ReduceFiles& files, const ReducedLog& log, size_t nameWidth,
                BatchResult& batch) {
    const std::string name = files.input.filename().string();
    batch.totals.merge(log.totals);
    batch.lines.push_back(summaryLineOf(log.totals, name, nameWidth));
    batch.bytesBefore += sizeOf(files.input);
    batch.bytesAfter += sizeOf(files.output);
    ++batch.done;
    for (const std::string& warning : log.warnings) {
        say(stderr, "warning: {}: {}\n", name, warning);
    }
}

void addFailed(const ReduceFiles& files, const std::string& error, size_t nameWidth,
               BatchResult& batch) {
    const std::string name = files.input.filename().string();
    batch.lines.push_back(fmt::format("{:{}}  failed: {}\n", name, nameWidth, error));
    const bool namesLog = error.find(name) != std::string::npos;
    say(stderr, "offmap: {}{}\n", namesLog ? "" : name + ": ", error);
}

BatchResult reduceAll(const ReduceJob& job, const std::vector<ReduceFiles>& logs) {
    size_t nameWidth = 0;
    for (const ReduceFiles& files : logs) {
        nameWidth = std::max(nameWidth, files.input.filename().string().size());
    }
    BatchResult batch;
    for (size_t i = 0; i < logs.size() && batch.interruption == 0; ++i) {
        const std::string title =
            fmt::format("{}/{} {}", i + 1, logs.size(), logs[i].input.filename().string());
        const LogOutcome outcome = reduceGuarded(job, {logs[i], title});
        if (outcome.reduced) {
            addReduced(logs[i], *outcome.reduced, nameWidth, batch);
        } else if (!outcome.error.empty()) {
            addFailed(logs[i], outcome.error, nameWidth, batch);
        }
        const bool died = outcome.guarded.kind == rawlog::GuardedOutcome::Kind::Died;
        if (!died) batch.interruption = outcome.guarded.signal;
        batch.exitCode = worse(batch.exitCode, outcome.exitCode);
    }
    return batch;
}

}  // namespace

int reduceBatch(const ReduceJob& job, const std::vector<ReduceFiles>& logs) {
    const auto begin = std::chrono::steady_clock::now();
    const ReduceOptions& options = job.options;
    const std::string folder = options.output.string();
    createFolders(options);
    const InterruptionsHeld held;
    if (!options.quiet) {
        say(stdout, "{}logs    {} into {}\n", summaryOf(job.map), logs.size(), folder);
    }
    const BatchResult batch = reduceAll(job, logs);
    if (!options.quiet) {
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        for (const std::string& line : batch.lines) say(stdout, "{}", line);
        say(stdout, "{}wrote   {} of {} logs into {} ({}, were {})\n",
            summaryOf(batch.totals, took.count()), batch.done, logs.size(), folder,
            sizeText(batch.bytesAfter), sizeText(batch.bytesBefore));
    }
    if (batch.interruption == 0) return batch.exitCode;
    say(stderr, "offmap: interrupted; {} of {} logs were written, nothing of the others\n",
        batch.done, logs.size());
    constexpr int firstSignal = 128;
    return firstSignal + batch.interruption;
}

}  // namespace offmap::app
