// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace offmap::app {

/// Exit codes, the same for every subcommand.
enum ExitCode : int {
    exitDone = 0,
    exitUsage = 1,       ///< the command line or the configuration is wrong
    exitFailed = 2,      ///< an input cannot be read or an output not written
    exitNotReduced = 3,  ///< with --strict: a scan could not be reduced
};

/// The command line asks for what cannot be meant; exit code 1.
class UsageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace offmap::app
