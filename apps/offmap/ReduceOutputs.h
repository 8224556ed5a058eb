// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFiles.h"
#include "ReduceOptions.h"

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/LogReduction.h>
#include <offmap/rawlog/RawlogWriter.h>
#include <offmap/rawlog/ReportFile.h>
#include <offmap/rawlog/SegmentsFile.h>

#include <nlohmann/json.hpp>

#include <optional>

namespace offmap::app {

/// The outputs of one reduction, all of which are complete before the first one appears.
class ReduceOutputs {
 public:
    ReduceOutputs(const ReduceFiles& files, const ReduceOptions& options,
                  rawlog::GuardedStatus& status);

    rawlog::LogReduction::Outputs logs();

    /// \param head of the report
    void begin(const nlohmann::ordered_json& head);
    /// What is to be added of a turn; may be called in several threads at once.
    rawlog::TurnNotes notesOf(uint64_t number, const rawlog::ReducedTurn& turn,
                              const core::ReductionResult& result, const core::LineMap& map) const;
    void add(const rawlog::TurnRecord& turn, const rawlog::TurnNotes& notes);
    /// \param tail of the report
    void finish(const rawlog::ReductionTotals& totals, const nlohmann::ordered_json& tail);
    void publish();

 private:
    rawlog::GuardedStatus& status_;
    std::optional<rawlog::RawlogWriter> reduced_, removed_, inspect_;
    std::optional<rawlog::ReportFile> report_;
    std::optional<rawlog::SegmentsFile> segments_;
};

}  // namespace offmap::app
