// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFigures.h>

#include <string>

namespace offmap::app {

/// How it is going, in a line. \param seconds [s] since the start
std::string runningLineOf(const live::LiveFigures& figures, double seconds);

/// What the summary of a live reduction says beside that of the log that it would make: latency,
/// drops, what did not come.
std::string liveSummaryOf(const live::LiveFigures& figures);

}  // namespace offmap::app
