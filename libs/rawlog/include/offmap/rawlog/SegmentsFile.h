// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionResult.h>
#include <offmap/rawlog/OutputFile.h>
#include <offmap/rawlog/TurnReducer.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace offmap::rawlog {

/// What became of every vertical segment and why, as CSV, a row each: written turn by turn, so that
/// it costs no memory. doc/formats.md tells what its columns mean.
class SegmentsFile {
 public:
    SegmentsFile(const std::filesystem::path& target, const OutputOptions& options);

    /// May be called in several threads at once. \param scan number of the turn in the log, from 0
    /// \param result of the same turn
    static std::string rowsOf(uint64_t scan, const ReducedTurn& turn,
                              const core::ReductionResult& result);
    void add(const std::string& rows) { file_.write(rows); }
    void finish() { file_.finish(); }
    void publish() { file_.publish(); }

 private:
    OutputFile file_;
};

}  // namespace offmap::rawlog
