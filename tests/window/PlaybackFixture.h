// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OfficeLogs.h"
#include "Playback.h"
#include "WaitFor.h"

#include <gmock/gmock.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace offmap::test {

/// A short log that is played, and the turns that came of it.
class PlaybackFixture : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        drive_ = officeDrive(turns);
        writeLog(log(), drive_);
    }
    static void TearDownTestSuite() { folder_.reset(); }
    using Numbers = std::vector<uint64_t>;

    static std::filesystem::path log() { return *folder_ / "drive.rawlog"; }

    void open(bool play, uint64_t startAt = 0) {
        app::LiveRequest request = requestOf(log(), {}).live;
        request.checkLog = [](const auto&, const auto&) {};
        app::LiveInput input = app::openLiveInput(request, config_);
        live::LiveSetup setup{std::make_shared<core::LineMap>(mapOf(evaluation::officeRoom())),
                              input.poses, config_};
        window::PlaybackEvents events;
        events.onFrame = [this](const live::LiveFramePtr& frame) { see(*frame); };
        events.onLatest = [this](const live::LiveFramePtr&) { ++latest_; };
        playback_ = std::make_unique<window::Playback>(std::move(input), std::move(setup),
                                                       std::move(events), play, startAt);
    }

    void see(const live::LiveFrame& frame) {
        while (held_ && frame.arrived.number >= heldFrom_) std::this_thread::yield();
        const std::lock_guard lock(mutex_);
        seen_.push_back(frame.arrived.number);
    }
    Numbers seen() const {
        const std::lock_guard lock(mutex_);
        return seen_;
    }
    bool comes(size_t count) const {
        return waitFor([&] { return seen().size() >= count; });
    }
    /// Waits until a turn was reduced, and those before it.
    bool comesTo(uint64_t number) const {
        return waitFor([&] {
            const auto frame = playback_->latest();
            return frame && frame->arrived.number == number;
        });
    }
    bool ends() const {
        return waitFor([&] {
            return playback_->figures().source.state == live::SourceState::Ended &&
                   playback_->figures().turnsWaiting == 0;
        });
    }
    /// The numbers from one to before the other.
    static Numbers fromTo(uint64_t first, uint64_t end) {
        Numbers numbers;
        for (uint64_t n = first; n < end; ++n) numbers.push_back(n);
        return numbers;
    }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline Observations drive_;
    static constexpr uint64_t turns = 12;  ///< of it
    rawlog::Config config_;
    std::atomic<bool> held_ = false;  ///< the reduction, at this turn
    std::atomic<uint64_t> heldFrom_ = 0;
    std::atomic<int> latest_ = 0;  ///< how often a result was told of
    mutable std::mutex mutex_;
    Numbers seen_;
    std::unique_ptr<window::Playback> playback_;  // last: its threads call what stands above
};

}  // namespace offmap::test
