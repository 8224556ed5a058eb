// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ColumnStream.h>
#include <offmap/rawlog/VelodyneColumns.h>
#include <offmap/rawlog/VelodynePackets.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// A firing is a column, clear as soon as its packet is there. Not before the turn is complete are
/// the second returns of dual return mode, which stand behind all first ones, any column of a
/// sensor with azimuth corrections, and any if the observation's time is not that of its first
/// packet. A turn that is taken piece by piece has one observation.
class VelodyneColumnStream final : public ColumnStream {
 public:
    /// Both have to outlive it.
    VelodyneColumnStream(const PoseSource& poses, const SensorConfig& config)
        : poses_(poses), config_(config) {}

    void add(const Turn& soFar, TurnScan& out) override;
    void finish(const Turn& turn, TurnScan& out) override;

 private:
    using Scan = mrpt::obs::CObservationVelodyneScan;

    /// What is known of the observation that is being taken.
    struct Progress {
        VelodyneReturns decoded;
        size_t packets = 0;  ///< that were decoded
        size_t firings = 0;  ///< whose columns were appended
    };

    void decode(const Scan& obs);
    void append(VelodyneColumns gathered, const Scan& obs, TurnScan& out);
    void orderUpward(std::span<uint32_t> returns);

    const PoseSource& poses_;
    const SensorConfig& config_;
    Progress progress_;
    uint32_t firstSlot_ = 0;         ///< of the observation
    std::vector<uint32_t> ofLaser_;  ///< working memory: a return each
};

}  // namespace offmap::rawlog
