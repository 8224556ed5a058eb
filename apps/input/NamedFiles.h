// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace offmap::app {

/// A file of the command line and how the command line calls it: "OUT", "--removed".
using NamedFile = std::pair<std::string, std::filesystem::path>;

/// Every file that is written must be another than all others; those that are only read may be the
/// same. Empty paths are passed over. \throw UsageError if two are the same file
void requireDistinct(const std::vector<NamedFile>& written,
                     const std::vector<NamedFile>& read = {});

}  // namespace offmap::app
