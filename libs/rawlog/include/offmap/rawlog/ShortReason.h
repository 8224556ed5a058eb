// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace offmap::rawlog {

/// What an exception of MRPT says, in a few printable words: it nests its messages, each with a
/// backtrace and source paths, and the innermost message says it.
std::string shortReason(const std::exception& error);

}  // namespace offmap::rawlog
