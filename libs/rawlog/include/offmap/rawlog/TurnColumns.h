// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ColumnStream.h>

#include <memory>

namespace offmap::rawlog {

/// The columns of one turn as they are reduced, while it is being taken: without the robot's own
/// returns, with the sigmas that the sensor's table tells.
class TurnColumns {
 public:
    /// \param sigmaRange [m] of returns whose intensity is not told. All have to outlive it.
    TurnColumns(const ScanClass& scanClass, const PoseSource& poses, const SensorConfig& config,
                double sigmaRange);

    /// Appends what is clear already, see ColumnStream::add().
    void add(const Turn& soFar);
    /// Appends what is left.
    void finish(const Turn& turn);

    /// Whether the poses that its columns were given still hold.
    bool hold() const { return poses_.settled().revision == revision_; }

    const core::OrganizedScan& scan() const { return turn_.scan; }
    TurnScan take() && { return std::move(turn_); }

 private:
    /// What was appended, from a column on.
    void complete(const Turn& turn, size_t firstColumn);

    const ScanClass& scanClass_;
    const PoseSource& poses_;
    const SensorConfig& config_;
    double sigmaRange_;  // [m]
    uint64_t revision_;  // of the poses
    std::unique_ptr<ColumnStream> stream_;
    TurnScan turn_;
};

}  // namespace offmap::rawlog
