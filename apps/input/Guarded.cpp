// SPDX-License-Identifier: BSD-3-Clause
#include "Guarded.h"

#include "Console.h"
#include "Progress.h"
#include "UsageError.h"

#include <cerrno>
#include <cstdio>
#include <exception>

namespace offmap::app {

namespace {

int exitCodeOfInterruption(int signal) {
    constexpr int firstSignal = 128;
    say(stderr, "{}: interrupted; nothing was written\n", program_invocation_short_name);
    return firstSignal + signal;
}

}  // namespace

int reportingErrors(const std::function<int()>& work) {
    try {
        return work();
    } catch (const UsageError& error) {
        say(stderr, "{}: {}\n", program_invocation_short_name, error.what());
        return exitUsage;
    } catch (const AlreadyTold& told) {
        return told.exitCode();
    } catch (const Interrupted& interrupted) {
        return exitCodeOfInterruption(interrupted.signal());
    } catch (const std::exception& error) {
        say(stderr, "{}: {}\n", program_invocation_short_name, error.what());
        return exitFailed;
    }
}

rawlog::GuardedOutcome reportingErrorsGuarded(
    const std::function<int(rawlog::GuardedStatus&)>& work) {
    auto outcome = rawlog::runGuarded([&work](rawlog::GuardedStatus& status) {
        return reportingErrors([&] { return work(status); });
    });
    if (outcome.kind != rawlog::GuardedOutcome::Kind::Finished) Progress::clearLeftover();
    return outcome;
}

int exitCodeOfInterruption(const rawlog::GuardedOutcome& outcome) {
    return exitCodeOfInterruption(outcome.signal);
}

}  // namespace offmap::app
