// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>

#include <memory>
#include <span>

namespace offmap::core {

/// What some columns tell by themselves, before their scan is complete.
struct ColumnVerdicts {
    std::span<const VerticalSegment> segments;
    /// One per segment: with the paper's method what its ray met, else its measured interval only.
    std::span<const SegmentMatch> matches;
};

/// Finds the returns of a scan that the map knows. Keeps its working memory from scan to scan; one
/// Reducer per thread. The map must outlive it.
class Reducer {
 public:
    /// \throw std::invalid_argument if the configuration is not valid.
    Reducer(const LineMap& map, const ReductionConfig& config);
    ~Reducer();
    Reducer(Reducer&&) noexcept;
    Reducer& operator=(Reducer&&) = delete;

    /// The result belongs to the reducer and holds until the next call.
    const ReductionResult& reduce(const OrganizedScan& scan);

    /// The same, while the scan is being taken: begin(), then add() whenever columns have been
    /// appended to it, and finish() when it is complete. What is left then is what needs the whole
    /// scan: the correction of its poses, extension along walls and labels.
    void begin();
    /// Takes in the columns behind those of the last call. \return what they tell; it may change
    /// when the scan is complete, and holds until the next call
    ColumnVerdicts add(const OrganizedScan& scan);
    /// Takes in the columns that are left, and finishes. The result holds until the next call.
    const ReductionResult& finish(const OrganizedScan& scan);

 private:
    struct Workspace;
    void finishByRays(const OrganizedScan& scan);
    void finishByGates(const OrganizedScan& scan);

    const LineMap& map_;
    std::unique_ptr<const ReductionConfig> config_;
    std::unique_ptr<Workspace> work_;
};

}  // namespace offmap::core
