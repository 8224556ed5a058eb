// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace offmap::app {

/// How much of a log there is to read.
struct ReadableLog {
    uint64_t entries =
        std::numeric_limits<uint64_t>::max();  ///< the reading ends before the next one
    std::string endsBecause;                   ///< why, if it is known not to be the end
};

}  // namespace offmap::app
