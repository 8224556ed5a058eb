// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/live/FreshestQueue.h>
#include <offmap/live/LiveFigures.h>
#include <offmap/live/LiveFrame.h>
#include <offmap/live/WaitingPieces.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/PoseSource.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace offmap::live {

/// What a live reduction works with. All are shared with it and must not change any more.
struct LiveSetup {
    std::shared_ptr<const core::LineMap> map;
    std::shared_ptr<const rawlog::PoseSource> poses;
    rawlog::Config config;
    rawlog::OutputClass output = rawlog::OutputClass::Same;
};

struct LiveOptions {
    size_t waiting = 2;  ///< turns that may wait; then the oldest is dropped
    /// Called for every turn by the thread that reduces, before the next one is reduced. What it
    /// throws ends the reduction.
    std::function<void(const LiveFramePtr&)> onFrame{};
    /// Called by the same thread whenever latest() has changed: for a turn that was reduced again,
    /// too. Must not throw.
    std::function<void(const LiveFramePtr&)> onLatest{};
};

class LiveWorkshop;

/// Reduces what a source delivers as it comes: one thread waits for the source, one reduces. Where
/// reducing is too slow the oldest waiting turn is dropped; a source that waits is not dropped
/// from. Pieces of a turn that is still going on are taken in while nothing else is to be done;
/// what comes of a turn is the same with and without.
class LiveReduction {
 public:
    /// Starts at once. \throw std::invalid_argument if the configuration is not valid
    LiveReduction(std::unique_ptr<ScanSource> source, LiveSetup setup, LiveOptions options = {});
    ~LiveReduction();
    LiveReduction(const LiveReduction&) = delete;
    LiveReduction& operator=(const LiveReduction&) = delete;

    /// The newest result; null before the first.
    LiveFramePtr latest() const;
    LiveFigures figures() const;

    /// From the next turn on, other parameters, map or poses. The latest turn is reduced again with
    /// them, and does not count twice. \throw std::invalid_argument if the configuration is not
    /// valid
    void change(LiveSetup setup);

    /// Whether all that the source delivered has been reduced and nothing more comes.
    bool finished() const;
    /// Waits until finished() or the time is over. \return finished()
    bool waitUntilFinished(std::chrono::milliseconds longest) const;
    /// Why the reduction ended, if it did before the source; else empty.
    std::string failure() const;

    /// Stops both threads and waits for their end; what was received last may not be reduced.
    void stop();

    ScanSource& source() { return *source_; }

 private:
    void receive(const std::stop_token& stop);
    void receivePiece(TurnPiece piece);
    void reduceAll(const std::stop_token& stop);
    void reduceNext(const ArrivedTurn& turn);
    void reduceLatestAgain();
    bool hasChanged() const;
    LiveFramePtr reduced(const ArrivedTurn& turn);
    void end(const std::string& failure);

    std::unique_ptr<ScanSource> source_;
    const LiveOptions options_;
    FreshestQueue<ArrivedTurn> queue_;
    WaitingPieces pieces_;  // of the turn behind those

    mutable std::mutex mutex_;  // of what follows
    mutable std::condition_variable_any ended_;
    std::unique_ptr<LiveWorkshop> changed_;  // to be used from now on
    LiveFramePtr latest_;
    rawlog::ReductionTotals totals_;
    rawlog::DurationHistogram latency_;
    RecentRate turns_, points_;
    bool finished_ = false;
    std::string failure_;

    std::unique_ptr<LiveWorkshop> workshop_;  // of the thread that reduces
    std::jthread receiver_, reducer_;         // last: they end before the rest does
};

}  // namespace offmap::live
