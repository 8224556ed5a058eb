// SPDX-License-Identifier: BSD-3-Clause
#include "FrameComposer.h"

#include "FrameIntensities.h"

#include <offmap/view/CorrectedScan.h>
#include <offmap/view/PoseMarks.h>
#include <offmap/view/Scene.h>

#include <algorithm>
#include <utility>

namespace offmap::window {

namespace {

/// Columns without a pose stand around the map's origin.
const mrpt::poses::CPose3D nowhere;

ComposedPtr composedOf(const live::LiveFramePtr& frame, const SceneChoices& choices,
                       const view::Palette& palette) {
    const auto& stated = frame->reduced.organized.scan;
    auto out = std::make_shared<Composed>();
    out->frame = frame;
    out->scan = view::correctedScan(stated, frame->result);
    out->returns = view::placedReturns(out->scan, frame->result.labels, nowhere);
    out->extent = view::extentOf(out->returns);
    if (choices.colourBy != view::ColourBy::Label) {
        out->returns.colours = view::coloursOf(out->returns, out->scan, frame->result,
                                               choices.colourBy, palette, intensitiesOf(*frame));
    }
    out->cloud = view::returnsOf(out->returns, sceneOptionsOf(choices, palette));
    const double width =
        std::max(out->extent.max.x - out->extent.min.x, out->extent.max.y - out->extent.min.y);
    constexpr double arrow = 0.06;  // of the picture's width
    if (choices.shown.ellipse) {
        out->poses = view::poseMarksOf(stated, frame->result, arrow * width, palette);
    }
    return out;
}

}  // namespace

FrameComposer::FrameComposer(std::function<void()> onComposed)
    : onComposed_(std::move(onComposed)),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

FrameComposer::~FrameComposer() {
    worker_.request_stop();
    worker_.join();
}

void FrameComposer::compose(live::LiveFramePtr frame, const SceneChoices& choices,
                            const view::Palette& palette) {
    {
        const std::lock_guard lock(mutex_);
        request_ = Request{std::move(frame), choices, palette};
    }
    changed_.notify_all();
}

ComposedPtr FrameComposer::take() {
    ComposedPtr taken;
    {
        const std::lock_guard lock(mutex_);
        taken = std::exchange(composed_, nullptr);
    }
    changed_.notify_all();
    return taken;
}

void FrameComposer::clear() {
    const std::lock_guard lock(mutex_);
    request_.reset();
    composed_.reset();
    ++cleared_;
}

void FrameComposer::work(const std::stop_token& stop) {
    for (;;) {
        Request request;
        uint64_t cleared = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return request_ && !composed_; })) return;
            request = std::move(*request_);
            request_.reset();
            cleared = cleared_;
        }
        ComposedPtr composed = composedOf(request.frame, request.choices, request.palette);
        {
            const std::lock_guard lock(mutex_);
            if (cleared != cleared_) continue;  // of a log that was closed meanwhile
            composed_ = std::move(composed);
        }
        onComposed_();
    }
}

}  // namespace offmap::window
