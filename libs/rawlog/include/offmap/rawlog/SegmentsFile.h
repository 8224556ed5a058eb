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

    /// \param result of the same turn
    void add(const ReducedTurn& turn, const core::ReductionResult& result);
    void finish() { file_.finish(); }
    void publish() { file_.publish(); }

 private:
    OutputFile file_;
    uint64_t scans_ = 0;
    std::string rows_;  ///< of one turn; reused
};

}  // namespace offmap::rawlog
