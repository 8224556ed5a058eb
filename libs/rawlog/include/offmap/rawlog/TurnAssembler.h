// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SweepTurns.h>
#include <offmap/rawlog/TurnCollector.h>

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// A turn and where in its log it stands.
struct PlacedTurn {
    Turn turn;
    uint64_t firstEntry = 0, lastEntry = 0;  ///< of the log
};

/// Makes turns of observations that come one after the other. Whether a 2D scanner turns shows
/// after its first scans: the turn in which that shows has lost these.
class TurnAssembler {
 public:
    /// \param log externally stored clouds are looked for beside it
    explicit TurnAssembler(const Config& config, std::filesystem::path log = {});

    /// Labels that are known to be of 2D scanners that turn, from their first scan on.
    void expectSweeps(const std::string& label) { sweeps_.insert_or_assign(label, true); }

    /// \return the turns that are now complete, in their order
    /// \throw std::runtime_error naming the file of a cloud that cannot be loaded
    std::vector<PlacedTurn> add(const mrpt::obs::CObservation::Ptr& obs, uint64_t entry);

    /// Ends the turns that are going on.
    std::vector<PlacedTurn> finish();

 private:
    struct Column {
        mrpt::obs::CObservation::ConstPtr scan;
        uint64_t entry;
    };
    bool isSweep(const mrpt::obs::CObservation2DRangeScan& scan);
    static std::vector<PlacedTurn> placed(const std::vector<std::vector<Column>>& turns);

    const Config& config_;
    std::filesystem::path log_;
    std::map<std::string, TurnCollector<Column>> open_;  // by label
    std::map<std::string, SweepDetector> detectors_;     // by label
    std::map<std::string, bool> sweeps_;                 // by label, as far as known
};

}  // namespace offmap::rawlog
