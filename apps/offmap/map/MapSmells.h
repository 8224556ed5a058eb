// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MapFacts.h"

#include <string>
#include <vector>

namespace offmap::app {

/// What may be wrong with a map of any format, each with its fix, but what its reader has warned of
/// already.
std::vector<std::string> smellsOf(const MapFacts& facts);

}  // namespace offmap::app
