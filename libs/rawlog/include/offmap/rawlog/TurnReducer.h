// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Reducer.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/PoseSource.h>
#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SensorConfigs.h>
#include <offmap/rawlog/TurnColumns.h>
#include <offmap/rawlog/TurnRecord.h>

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

enum class OutputClass : uint8_t {
    Same,    ///< the observation's own class
    Points,  ///< CObservationPointCloud
};

/// A turn with its mapped returns taken out.
struct ReducedTurn {
    TurnRecord record;
    TurnScan organized;
    /// Per observation of the turn; null if nothing was removed from it, so that it may be copied
    /// as it is.
    std::vector<mrpt::obs::CObservation::Ptr> reduced;
    std::vector<uint8_t> removedSlots;        ///< per slot of the turn, 0 or 1
    std::vector<uint64_t> returnsPerSegment;  ///< those that repeat a point counted too
    std::vector<uint64_t> removedPerSegment;  ///< of these
    /// At the time of the record, see refinedPose(); none if the scan did not correct it.
    std::optional<mrpt::poses::CPose3DPDFGaussian> vehicleInMap;
};

/// Reduces observations in memory: organises them into columns, asks core what is mapped, takes it
/// out.
class TurnReducer {
 public:
    /// Map and poses must outlive it. \throw std::invalid_argument if the configuration is not
    /// valid.
    TurnReducer(const core::LineMap& map, const PoseSource& poses, const Config& config,
                OutputClass output);

    ReducedTurn reduce(const Turn& turn, const ScanClass& scanClass);

    /// The same, while the turn is being taken: begin(), then add() whenever there is more of it,
    /// and finish() when it is complete. What is left then are its last columns, those whose poses
    /// were not settled, and what needs all of them.
    void begin(const ScanClass& scanClass);
    /// \param soFar what there is of the turn: all that the last call had, and more
    void add(const Turn& soFar);
    ReducedTurn finish(const Turn& turn);

    /// What was found out about the last turn; holds until there is some of the next one.
    const core::ReductionResult& result() const { return *result_; }

    /// Per observation of the turn, one that holds the removed returns only.
    std::vector<mrpt::obs::CObservation::Ptr> removedFrom(const Turn& turn,
                                                          const ReducedTurn& reduced,
                                                          const ScanClass& scanClass) const;

 private:
    mrpt::obs::CObservation::Ptr select(const mrpt::obs::CObservation& obs,
                                        const ScanClass& scanClass, SlotMask keep,
                                        Leftovers leftovers, const SensorConfig& config) const;

    void takeOut(const Turn& turn, ReducedTurn& out);
    /// Of the turn that was begun; anew if its poses have changed since.
    TurnColumns& columns(const Turn& turn);

    core::Reducer reducer_;
    const PoseSource& poses_;
    Config config_;
    SensorConfigs sensors_;
    OutputClass output_;
    const ScanClass* scanClass_ = nullptr;         // of the turn that was begun
    std::unique_ptr<TurnColumns> columns_;         // of it, once there is some of it
    std::chrono::steady_clock::duration spent_{};  // on it so far
    const core::ReductionResult* result_ = nullptr;
};

}  // namespace offmap::rawlog
