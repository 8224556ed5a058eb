// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Studies.h"

#include <string>
#include <vector>

namespace offmap::accuracy {

/// A figure that must not be above, or not be below, a limit.
struct Bound {
    std::string what;
    double measured;
    double limit;
    bool atMost;
    std::string unit;  ///< with a leading space

    bool met() const { return atMost ? measured <= limit : measured >= limit; }
};

/// What is demanded of the methods. A quick run has few scans: its limits are half a percent
/// looser.
std::vector<Bound> boundsOf(const Studies& studies, const Extent& extent);

}  // namespace offmap::accuracy
