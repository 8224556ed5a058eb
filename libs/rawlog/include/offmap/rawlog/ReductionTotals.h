// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/HealthTotals.h>
#include <offmap/rawlog/TurnRecord.h>

#include <mrpt/core/Clock.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// Durations in bins of 1 %, so that a median costs the same memory for an hour's log and for a
/// year's.
class DurationHistogram {
 public:
    DurationHistogram() : bins_(binCount, 0) {}
    /// \param bins of another one \throw std::invalid_argument if they cannot be
    explicit DurationHistogram(std::vector<uint64_t> bins);

    void add(double milliseconds);
    void merge(const DurationHistogram& other);
    const std::vector<uint64_t>& bins() const { return bins_; }
    /// [ms] to within 0.5 %; none without a duration.
    std::optional<double> quantile(double share) const;

 private:
    static constexpr size_t binCount = 2400;  // 1e-4 ms ... 2e6 ms
    std::vector<uint64_t> bins_;
    uint64_t count_ = 0;
};

/// What became of a whole log, or of several, in figures.
struct ReductionTotals {
    uint64_t scans = 0;                            ///< turns
    std::map<std::string, uint64_t> notReduced;    ///< turns kept whole, by reason
    std::map<std::string, uint64_t> notSupported;  ///< 3D observations copied unchanged, by reason
    uint64_t columns = 0, columnsWithoutPose = 0;
    ReturnCounts counts;
    uint64_t onVerticalSegments = 0;                                          ///< points
    uint64_t removedByRay = 0, removedByExtension = 0, removedAsOrphans = 0;  ///< points
    uint64_t removedByPoint = 0, keptOffWall = 0;                             ///< points
    std::array<uint64_t, core::keepReasonCount> keptByReason{};               ///< points
    HealthTotals health;
    DurationHistogram milliseconds;                              ///< per turn
    std::optional<mrpt::Clock::time_point> firstTime, lastTime;  ///< of turns
    double mergedLogSeconds = 0;  ///< [s] of the logs that were merged into these

    void add(const TurnRecord& turn);
    /// Adds what became of another log.
    void merge(const ReductionTotals& other);

    uint64_t removed() const {
        return removedByRay + removedByExtension + removedAsOrphans + removedByPoint;
    }
    uint64_t keptOnSegments() const;  ///< points on vertical segments
    uint64_t removedOnSegments() const { return onVerticalSegments - keptOnSegments(); }
    uint64_t scansNotReduced() const;
    uint64_t observationsNotSupported() const;
    /// [s] from the first to the last turn of the log; of several, the sum.
    double logSeconds() const;

    /// What smells, a sentence each that says what to look at.
    std::vector<std::string> warnings() const;
};

}  // namespace offmap::rawlog
