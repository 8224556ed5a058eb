// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceOptions.h"

#include <filesystem>
#include <vector>

namespace offmap::app {

/// The files of one reduction; all but the first two may be empty.
struct ReduceFiles {
    std::filesystem::path input, output, removed, report, segments, inspect;
};

/// Whether OUT and the other outputs name folders, in which each log has its own files.
bool writesFolders(const ReduceOptions& options);

/// The files of each log. \throw UsageError if two of them would be the same, or if what should be
/// a folder is a file
std::vector<ReduceFiles> filesOf(const ReduceOptions& options);

/// Makes the folders that outputs go to. \throw std::runtime_error naming folder, cause and fix
void createFolders(const ReduceOptions& options);

}  // namespace offmap::app
