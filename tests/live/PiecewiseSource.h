// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/SimulatedRobot.h"
#include "CountedPoses.h"

#include <offmap/live/ScanSource.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace offmap::test {

using VelodyneObservation = mrpt::obs::CObservationVelodyneScan;

inline constexpr size_t pieceSize = 5, packetsOfTurn = 75, columnsOfPacket = 24;

inline live::TurnPiece pieceOf(const VelodyneObservation& whole, uint64_t turn, size_t first) {
    auto packets = std::make_shared<VelodyneObservation>(whole);
    const auto begin = whole.scan_packets.begin() + static_cast<std::ptrdiff_t>(first);
    packets->scan_packets.assign(begin, begin + pieceSize);
    return {turn, first, packets};
}

/// A VLP-16 on a robot that stands in the office. Of each turn all pieces but the last come before.
class PiecewiseSource : public live::ScanSource {
 public:
    explicit PiecewiseSource(size_t turns) {
        test::SimulatedRobot robot;
        for (size_t t = 0; t < turns; ++t) {
            scans_.push_back(robot.vlp16());
            robot.wait(0.1);
        }
    }

    /// Called before the pieces of the turn are handed over: while another turn waits, they would
    /// be passed over.
    std::function<void(uint64_t turn)> beforePieces = [](uint64_t) {};
    /// By default, all pieces as they are.
    std::function<void(PiecewiseSource&, uint64_t turn)> handOverPieces =
        [](PiecewiseSource& source, uint64_t turn) { source.handOverFrom(turn, 0); };
    /// Called before the turn is delivered.
    std::function<void(uint64_t turn)> beforeTurn = [](uint64_t) {};
    bool waitsForReader = true;

    std::optional<live::ArrivedTurn> next(const std::stop_token& stop) override {
        ended_ = next_ == scans_.size();
        if (ended_ || stop.stop_requested()) return std::nullopt;
        const uint64_t turn = next_++;
        beforePieces(turn);
        handOverPieces(*this, turn);
        beforeTurn(turn);
        return live::ArrivedTurn{{scans_[turn]}, turn, std::chrono::steady_clock::now()};
    }
    live::SourceHealth health() const override { return {live::SourceState::Running, {}, next_}; }
    bool waits() const override { return waitsForReader; }
    /// Whether it was asked for more than it has.
    bool ended() const { return ended_; }

    void handOverFrom(uint64_t turn, size_t first) {
        for (; first + pieceSize < packetsOfTurn; first += pieceSize) {
            handOver(pieceOf(*scans_[turn], turn, first));
        }
    }
    void give(live::TurnPiece piece) { handOver(std::move(piece)); }
    VelodyneObservation::Ptr scan(uint64_t turn) const { return scans_[turn]; }

 private:
    std::vector<VelodyneObservation::Ptr> scans_;
    std::atomic<uint64_t> next_ = 0;
    std::atomic<bool> ended_ = false;
};

/// All columns of a turn, and the pose at its time, which the scan corrects.
inline constexpr size_t lookupsOfTurn = packetsOfTurn * columnsOfPacket + 1;
/// Of the columns of its pieces.
inline constexpr size_t lookupsBefore = (packetsOfTurn - pieceSize) * columnsOfPacket;

/// Lets a turn come when all of its pieces were taken in, and no piece before the turn before was.
inline void awaitAll(PiecewiseSource& source, const CountedPoses& poses) {
    source.beforePieces = [&poses](uint64_t turn) {
        EXPECT_TRUE(poses.waitFor(turn * lookupsOfTurn)) << turn;
    };
    source.beforeTurn = [&poses](uint64_t turn) {
        EXPECT_TRUE(poses.waitFor(turn * lookupsOfTurn + lookupsBefore)) << turn;
    };
}

}  // namespace offmap::test
