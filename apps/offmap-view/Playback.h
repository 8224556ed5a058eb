// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/LiveInput.h"
#include "input/LiveRecorder.h"

#include <offmap/live/LiveReduction.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace offmap::window {

/// Called by the thread that reduces.
struct PlaybackEvents {
    std::function<void(const live::LiveFramePtr&)> onFrame;  ///< for every turn
    std::function<void(const live::LiveFramePtr&)>
        onLatest;  ///< of a turn that is reduced again, too
};

/// A source that is being reduced, and its controls. Any thread may use it.
class Playback {
 public:
    /// \param play else a log waits at its first turn \param startAt turn of a log
    Playback(app::LiveInput input, live::LiveSetup setup, PlaybackEvents events, bool play,
             uint64_t startAt);
    ~Playback();
    Playback(const Playback&) = delete;
    Playback& operator=(const Playback&) = delete;

    live::LiveFramePtr latest() const { return reduction_->latest(); }
    live::LiveFigures figures() const { return reduction_->figures(); }
    live::SourceHealth health() const { return reduction_->source().health(); }
    /// Why it ended before its source did; empty: it did not.
    std::string failure() const { return reduction_->failure(); }

    /// The latest turn is reduced again at once.
    /// \throw std::invalid_argument if the configuration is not valid
    void setConfig(const rawlog::Config& config);

    bool canPause() const { return input_.replay != nullptr; }
    bool playing() const;
    /// From the beginning, if it is at its end.
    void play();
    void pause();
    /// The turn after the latest one, or the one before; it pauses.
    void step(int turns);
    void jumpTo(uint64_t turn);
    /// \param factor as of live::ReplayClock
    void setSpeed(double factor);

    /// Records what is reduced from now on. \throw std::runtime_error naming the file
    void record(const std::filesystem::path& file);
    bool recording() const;
    /// The recording appears. \throw std::runtime_error naming the file, also if it has ended
    /// before because it could not be written
    /// \return the file
    std::filesystem::path finishRecording();
    /// Whether it has so ended, and finishRecording() will tell.
    bool recordingFailed() const;

 private:
    void take(const live::LiveFramePtr& frame);
    void addToRecording(const live::LiveFrame& frame);

    app::LiveInput input_;
    live::LiveSetup setup_;
    const PlaybackEvents events_;
    mutable std::mutex mutex_;  // of what follows
    bool playing_;
    std::unique_ptr<app::LiveRecorder> recorder_;
    std::filesystem::path recordingTo_;
    std::string recordingFailure_;  // of the recording that was going on; empty: none
    std::unique_ptr<live::LiveReduction> reduction_;  // last: its threads end before the rest does
};

}  // namespace offmap::window
