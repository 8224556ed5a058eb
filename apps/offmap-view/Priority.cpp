// SPDX-License-Identifier: BSD-3-Clause
#include "Priority.h"

#include <sys/resource.h>

namespace offmap::window {

void standBack() {
    // Linux counts the niceness by threads. At 5, one gets a third of what another one gets.
    constexpr int niceness = 5;
    if (getpriority(PRIO_PROCESS, 0) < niceness) setpriority(PRIO_PROCESS, 0, niceness);
}

}  // namespace offmap::window
