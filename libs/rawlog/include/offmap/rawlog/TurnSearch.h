// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/TurnAssembler.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace offmap::rawlog {

/// The first turn of a log that begins at an entry, goes on there or begins later.
/// \param input the log's own path; externally stored clouds are looked for beside it
/// \param onEntry called before each entry is read
std::optional<Turn> findTurn(RawlogReader& reader, const LogSurvey& survey, const Config& config,
                             uint64_t entry, const std::filesystem::path& input,
                             const std::function<void()>& onEntry);

/// Tells an assembler which 2D scanners of a log turn.
void expectSweepsOf(const LogSurvey& survey, TurnAssembler& assembler);

}  // namespace offmap::rawlog
