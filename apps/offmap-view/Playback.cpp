// SPDX-License-Identifier: BSD-3-Clause
#include "Playback.h"

#include "input/NamedFiles.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace offmap::window {

Playback::Playback(app::LiveInput input, live::LiveSetup setup, PlaybackEvents events, bool play,
                   uint64_t startAt)
    : input_(std::move(input)),
      setup_(std::move(setup)),
      events_(std::move(events)),
      playing_(play || !input_.replay) {
    if (!playing_) input_.replay->pause();
    if (input_.replay) input_.replay->jumpTo(startAt);
    live::LiveOptions options;
    options.onFrame = [this](const live::LiveFramePtr& frame) { take(frame); };
    options.onLatest = events_.onLatest;
    reduction_ =
        std::make_unique<live::LiveReduction>(std::move(input_.source), setup_, std::move(options));
}

Playback::~Playback() { reduction_->stop(); }

void Playback::take(const live::LiveFramePtr& frame) {
    if (input_.tracked && frame->reduced.vehicleInMap) {
        input_.tracked->correct(*frame->reduced.vehicleInMap, frame->reduced.record.time);
    }
    addToRecording(*frame);
    events_.onFrame(frame);
}

/// A disk that is full ends the recording, not the reduction.
void Playback::addToRecording(const live::LiveFrame& frame) {
    const std::lock_guard lock(mutex_);
    if (!recorder_) return;
    try {
        recorder_->add(frame);
    } catch (const std::exception& error) {
        recordingFailure_ = error.what();
        recorder_.reset();
    }
}

void Playback::setConfig(const rawlog::Config& config) {
    const std::lock_guard lock(mutex_);
    setup_.config = config;
    reduction_->change(setup_);
}

bool Playback::playing() const {
    const std::lock_guard lock(mutex_);
    return playing_ && !reduction_->finished() &&
           !(canPause() && health().state == live::SourceState::Ended);
}

void Playback::play() {
    if (!canPause()) return;
    if (health().state == live::SourceState::Ended) input_.replay->jumpTo(0);
    const std::lock_guard lock(mutex_);
    playing_ = true;
    input_.replay->resume();
}

void Playback::pause() {
    if (!canPause()) return;
    const std::lock_guard lock(mutex_);
    playing_ = false;
    input_.replay->pause();
}

void Playback::step(int turns) {
    if (!canPause()) return;
    pause();
    const live::LiveFramePtr frame = latest();
    const auto now = frame ? static_cast<int64_t>(frame->arrived.number) : -1;
    const int64_t wanted = std::max<int64_t>(0, now + turns);
    if (turns == 1) {
        input_.replay->step();
    } else {
        jumpTo(static_cast<uint64_t>(wanted));
    }
}

// NOLINTNEXTLINE(readability-make-member-function-const): what is played changes
void Playback::jumpTo(uint64_t turn) {
    if (canPause()) input_.replay->jumpTo(turn);
}

// NOLINTNEXTLINE(readability-make-member-function-const): what is played changes
void Playback::setSpeed(double factor) {
    if (canPause()) input_.replay->setSpeed(factor);
}

void Playback::record(const std::filesystem::path& file) {
    app::requireDistinct({{"the recording", file}}, {{"what is being read", input_.file}});
    auto recorder = std::make_unique<app::LiveRecorder>(file, true);
    const std::lock_guard lock(mutex_);
    recorder_ = std::move(recorder);
    recordingTo_ = file;
    recordingFailure_.clear();
}

bool Playback::recording() const {
    const std::lock_guard lock(mutex_);
    return recorder_ != nullptr;
}

bool Playback::recordingFailed() const {
    const std::lock_guard lock(mutex_);
    return !recordingFailure_.empty();
}

std::filesystem::path Playback::finishRecording() {
    std::filesystem::path file;
    std::unique_ptr<app::LiveRecorder> recorder;
    {
        const std::lock_guard lock(mutex_);
        file = recordingTo_;
        recorder = std::move(recorder_);
        if (!recordingFailure_.empty()) {
            throw std::runtime_error(std::exchange(recordingFailure_, {}));
        }
    }
    if (recorder) recorder->publish();
    return file;
}

}  // namespace offmap::window
