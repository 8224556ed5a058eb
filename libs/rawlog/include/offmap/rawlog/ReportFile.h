// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/OutputFile.h>
#include <offmap/rawlog/ReductionTotals.h>
#include <offmap/rawlog/TurnRecord.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace offmap::rawlog {

/// The totals as a report holds them.
nlohmann::ordered_json toJson(const ReductionTotals& totals);

/// The other way round, but for the durations of single scans, which a report does not hold.
/// \throw nlohmann::json::exception if it is something else
ReductionTotals totalsFrom(const nlohmann::ordered_json& json);

/// A record of a reduction as JSON, written turn by turn, so that it costs no memory. Its keys are
/// stable; doc/formats.md tells what they mean.
class ReportFile {
 public:
    ReportFile(const std::filesystem::path& target, const OutputOptions& options)
        : file_(target, options) {}

    /// \param head members that come before the scans: what was reduced, with what
    void begin(const nlohmann::ordered_json& head);
    void add(const TurnRecord& turn);
    /// \param tail members that come after the totals
    void finish(const ReductionTotals& totals, const nlohmann::ordered_json& tail);
    void publish() { file_.publish(); }

 private:
    OutputFile file_;
    uint64_t scans_ = 0;
};

}  // namespace offmap::rawlog
