// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace offmap::app {

inline constexpr const char* liveDescription =
    "Reduce what a sensor, a capture or a log delivers, as it comes";

/// Runs offmap-live, which stands beside this program, in its place: the drivers of sensors that it
/// needs bring 150 libraries along, of windows and videos, for which all else need not wait.
/// \param argv this program's name and what follows "live" \return an exit code, if there is no
/// such program
int becomeLiveProgram(char** argv);

}  // namespace offmap::app
