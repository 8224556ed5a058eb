// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace offmap::live {

using SteadyTime = std::chrono::steady_clock::time_point;

/// A turn as it came from its source.
struct ArrivedTurn {
    rawlog::Turn turn;
    uint64_t number = 0;  ///< of the source's turns, from 0
    SteadyTime arrived;   ///< when the last of it was there
};

enum class SourceState : uint8_t {
    Starting,  ///< nothing has come yet
    Running,
    Stalled,  ///< nothing has come for longer than it should; it may come again
    Ended,    ///< nothing more will come
    Failed,   ///< nothing more will come, for a reason
};

/// Some of a turn that is still going on. All that is in it comes again with the turn.
struct TurnPiece {
    uint64_t turn = 0;       ///< the number that it will have
    size_t firstPacket = 0;  ///< of the turn, from 0
    /// As the turn's observation, with some of its packets.
    std::shared_ptr<const mrpt::obs::CObservationVelodyneScan> packets;
};

/// "starting", "running", ...
std::string_view toString(SourceState state);

/// How a source is.
struct SourceHealth {
    SourceState state = SourceState::Starting;
    std::string message;           ///< why, where that helps; empty: nothing to tell
    uint64_t received = 0;         ///< turns
    uint64_t packetsMissing = 0;   ///< that the stamps of the others say there were
    uint64_t connectionsLost = 0;  ///< times that it stalled after it had run
};

/// Where turns come from. next() is called by one thread, health() by any.
class ScanSource {
 public:
    virtual ~ScanSource() = default;

    /// Waits for the next turn; none if it was stopped or nothing more comes.
    virtual std::optional<ArrivedTurn> next(const std::stop_token& stop) = 0;

    /// Asks for pieces of turns as they come, if the source has any; next() hands them over, in
    /// their order. To be called before next() is.
    void onPiece(std::function<void(TurnPiece)> use) { usePiece_ = std::move(use); }

    virtual SourceHealth health() const = 0;

    /// Whether turns wait for whoever reads them, so that none need be dropped.
    virtual bool waits() const { return false; }

 protected:
    bool wantsPieces() const { return usePiece_ != nullptr; }
    void handOver(TurnPiece piece) const { usePiece_(std::move(piece)); }

 private:
    std::function<void(TurnPiece)> usePiece_;
};

}  // namespace offmap::live
