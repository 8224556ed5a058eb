// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoAdvice.h"

#include <string>

namespace offmap::app {

/// The same as a JSON document; doc/formats.md tells what its keys mean.
std::string infoJson(const LogFacts& facts, const Advice& advice);

}  // namespace offmap::app
