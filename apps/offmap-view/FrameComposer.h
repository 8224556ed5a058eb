// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SceneChoices.h"

#include <offmap/live/LiveFrame.h>
#include <offmap/view/Palette.h>
#include <offmap/view/PlacedReturns.h>

#include <mrpt/opengl/CSetOfObjects.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace offmap::window {

/// A result that is ready to be drawn. Its objects belong to the canvas that draws them first.
struct Composed {
    live::LiveFramePtr frame;
    core::OrganizedScan scan;  ///< where it was found to have been taken from
    view::PlacedReturns returns;
    mrpt::math::TBoundingBox extent;                ///< [m] map frame, worth looking at
    mrpt::opengl::CSetOfObjects::Ptr cloud, poses;  ///< for the scene
};
using ComposedPtr = std::shared_ptr<const Composed>;

/// Makes scenes of results on a thread of its own: the newest that it was given, as often as they
/// are taken, and no more.
class FrameComposer {
 public:
    /// \param onComposed called by the composer's thread; then take() has something to give
    explicit FrameComposer(std::function<void()> onComposed);
    ~FrameComposer();

    void compose(live::LiveFramePtr frame, const SceneChoices& choices,
                 const view::Palette& palette);
    /// What was composed last; null if that was taken already.
    ComposedPtr take();
    /// Forgets what is waiting.
    void clear();

 private:
    struct Request {
        live::LiveFramePtr frame;
        SceneChoices choices;
        view::Palette palette;
    };
    void work(const std::stop_token& stop);

    const std::function<void()> onComposed_;
    std::mutex mutex_;  // of what follows
    std::condition_variable_any changed_;
    std::optional<Request> request_;
    ComposedPtr composed_;
    uint64_t cleared_ = 0;
    std::jthread worker_;  // last: it ends before the rest does
};

}  // namespace offmap::window
