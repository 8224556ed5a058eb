// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoAdvice.h"

namespace offmap::app {

/// What to do about the poses of a log that holds 3D scans.
void advisePoses(const LogFacts& facts, const rawlog::Config& config, Advice& advice);

}  // namespace offmap::app
