// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoAdvice.h"

#include <string>

namespace offmap::app {

/// What a log holds and what it lacks, for a person to read.
std::string infoText(const LogFacts& facts, const Advice& advice);

}  // namespace offmap::app
