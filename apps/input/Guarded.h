// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/GuardedRun.h>

#include <exception>
#include <functional>

namespace offmap::app {

/// SIGINT, SIGTERM or SIGHUP came before anything was written.
class Interrupted : public std::exception {
 public:
    explicit Interrupted(int signal) : signal_(signal) {}
    int signal() const { return signal_; }

 private:
    int signal_;
};

/// A child has said what is wrong; only its exit code is left to hand on.
class AlreadyTold : public std::exception {
 public:
    explicit AlreadyTold(int exitCode) : exitCode_(exitCode) {}
    int exitCode() const { return exitCode_; }

 private:
    int exitCode_;
};

/// Does the work and turns what it throws into a message on stderr and an exit code.
int reportingErrors(const std::function<int()>& work);

/// The same in a child of this program, which survives what corrupt logs do to their reader. The
/// outcome's kind tells whether the work came to its end.
rawlog::GuardedOutcome reportingErrorsGuarded(
    const std::function<int(rawlog::GuardedStatus&)>& work);

/// As a shell tells a program that a signal ended; says that nothing was written.
int exitCodeOfInterruption(const rawlog::GuardedOutcome& outcome);

}  // namespace offmap::app
