// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWorkshop.h"

#include <offmap/live/LiveReduction.h>

#include <utility>

namespace offmap::live {

using Steady = std::chrono::steady_clock;

LiveReduction::LiveReduction(std::unique_ptr<ScanSource> source, LiveSetup setup,
                             LiveOptions options)
    : source_(std::move(source)),
      options_(std::move(options)),
      queue_(options_.waiting),
      workshop_(std::make_unique<LiveWorkshop>(std::move(setup))),
      receiver_([this](const std::stop_token& stop) { receive(stop); }),
      reducer_([this](const std::stop_token& stop) { reduceAll(stop); }) {}

LiveReduction::~LiveReduction() { stop(); }

void LiveReduction::stop() {
    for (std::jthread* thread : {&receiver_, &reducer_}) thread->request_stop();
    for (std::jthread* thread : {&receiver_, &reducer_}) {
        if (thread->joinable()) thread->join();
    }
}

void LiveReduction::receive(const std::stop_token& stop) {
    source_->onPiece([this](TurnPiece piece) { receivePiece(std::move(piece)); });
    while (auto turn = source_->next(stop)) {
        pieces_.clear();
        if (source_->waits()) {
            if (!queue_.pushAll(std::move(*turn), stop)) break;
        } else {
            queue_.push(std::move(*turn));
        }
    }
    queue_.close();
}

/// Whoever is behind with turns has no time for pieces.
void LiveReduction::receivePiece(TurnPiece piece) {
    if (queue_.size() > 0) return;
    pieces_.add(std::move(piece));
    queue_.nudge();
}

void LiveReduction::reduceAll(const std::stop_token& stop) {
    try {
        while (!stop.stop_requested() && !queue_.ended()) {
            if (const auto turn = queue_.pop(stop)) {
                reduceNext(*turn);
                continue;
            }
            while (const auto piece = pieces_.take()) workshop_->take(*piece);
            if (!stop.stop_requested() && hasChanged()) reduceLatestAgain();
        }
        end({});
    } catch (const std::exception& error) {
        receiver_.request_stop();
        end(error.what());
    }
}

LiveFramePtr LiveReduction::reduced(const ArrivedTurn& turn) {
    {
        const std::lock_guard lock(mutex_);
        if (changed_) workshop_ = std::move(changed_);
    }
    auto frame = std::make_shared<LiveFrame>();
    frame->arrived = turn;
    frame->reduced = workshop_->reduce(turn.turn);
    frame->result = workshop_->result();
    frame->latency =
        std::chrono::duration<double, std::milli>(Steady::now() - turn.arrived).count();
    return frame;
}

void LiveReduction::reduceNext(const ArrivedTurn& turn) {
    const LiveFramePtr frame = reduced(turn);
    {
        const std::lock_guard lock(mutex_);
        const auto now = Steady::now();
        latest_ = frame;
        totals_.add(frame->reduced.record);
        latency_.add(frame->latency);
        turns_.add(now, 1);
        points_.add(now, static_cast<double>(frame->reduced.record.counts.returns));
    }
    if (options_.onFrame) options_.onFrame(frame);
    if (options_.onLatest) options_.onLatest(frame);
}

bool LiveReduction::hasChanged() const {
    const std::lock_guard lock(mutex_);
    return changed_ != nullptr;
}

void LiveReduction::reduceLatestAgain() {
    const LiveFramePtr before = latest();
    if (!before) return;
    const LiveFramePtr frame = reduced(before->arrived);
    {
        const std::lock_guard lock(mutex_);
        latest_ = frame;
    }
    if (options_.onLatest) options_.onLatest(frame);
}

void LiveReduction::end(const std::string& failure) {
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
        failure_ = failure;
    }
    ended_.notify_all();
}

LiveFramePtr LiveReduction::latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
}

LiveFigures LiveReduction::figures() const {
    LiveFigures figures;
    figures.source = source_->health();
    figures.turnsDropped = queue_.dropped();
    figures.turnsWaiting = queue_.size();
    const std::lock_guard lock(mutex_);
    const auto now = Steady::now();
    figures.totals = totals_;
    figures.latency = latency_;
    figures.turnsPerSecond = turns_.perSecond(now);
    figures.pointsPerSecond = points_.perSecond(now);
    return figures;
}

void LiveReduction::change(LiveSetup setup) {
    auto workshop = std::make_unique<LiveWorkshop>(std::move(setup));
    {
        const std::lock_guard lock(mutex_);
        changed_ = std::move(workshop);
    }
    queue_.nudge();
}

bool LiveReduction::finished() const {
    const std::lock_guard lock(mutex_);
    return finished_;
}

bool LiveReduction::waitUntilFinished(std::chrono::milliseconds longest) const {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, longest, [&] { return finished_; });
}

std::string LiveReduction::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

}  // namespace offmap::live
