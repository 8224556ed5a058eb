// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LogScore.h"

#include <filesystem>
#include <string>

namespace offmap::app {

/// What was scored, by its files' names.
struct ScoredFiles {
    std::filesystem::path truth, log;
};

/// For people: a table.
std::string scoreText(const LogScore& score, const ScoredFiles& files);

/// For programs: doc/formats.md tells its keys.
std::string scoreJson(const LogScore& score, const ScoredFiles& files);

}  // namespace offmap::app
