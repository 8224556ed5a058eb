// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/LogInventory.h>

#include <string>

namespace offmap::app {

/// The 3D sensors of a log and their scans.
std::string scannerSection(const rawlog::LogInventory& inventory);

/// Everything else that a log holds, except poses.
std::string othersSection(const rawlog::LogInventory& inventory);

}  // namespace offmap::app
