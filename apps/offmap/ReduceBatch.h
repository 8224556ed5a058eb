// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceJob.h"

#include <vector>

namespace offmap::app {

/// Reduces logs one after the other, each in a child of its own, and prints what came of them. What
/// is wrong with one does not stop the others; an interruption stops all, and leaves those that are
/// done. \return the worst exit code
int reduceBatch(const ReduceJob& job, const std::vector<ReduceFiles>& logs);

}  // namespace offmap::app
