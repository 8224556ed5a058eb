// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FrameComposer.h"
#include "ScanCanvas.h"
#include "SceneChoices.h"
#include "Theme.h"
#include "ViewState.h"

#include <offmap/core/LineMap.h>
#include <offmap/view/SegmentStory.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <wx/panel.h>
#include <wx/timer.h>

namespace offmap::window {

/// The canvas with what stands on it: the newest scan, the map, and the segment that was clicked.
class ScanStage : public wxPanel {
 public:
    explicit ScanStage(wxWindow* parent);

    void setMap(std::shared_ptr<const core::LineMap> map);
    const core::LineMap& map() const { return *map_; }
    std::shared_ptr<const core::LineMap> sharedMap() const { return map_; }
    /// Any thread may call it; what comes too fast to be drawn is passed over.
    void take(const live::LiveFramePtr& frame);
    void clear();

    void setTheme(const Theme& theme);
    void setChoices(const SceneChoices& choices);
    const SceneChoices& choices() const { return choices_; }

    void setCameraMode(CameraMode mode);
    CameraMode cameraMode() const { return cameraMode_; }
    void setCamera(const view::Camera& camera) { canvas_->setCamera(camera); }
    const view::Camera& camera() const { return canvas_->camera(); }
    /// The whole scan, or without one the whole map, in the picture.
    void resetView();
    void lookAt(const mrpt::math::TPoint2D& place);

    void clearSelection();
    ScanCanvas& canvas() { return *canvas_; }

    /// Null: none.
    const ComposedPtr& shown() const { return shown_; }

    /// A scan has come to the screen; it was composed from this. Scans that come faster than
    /// anybody reads figures are passed over.
    std::function<void(const Composed&)> onShown = [](const Composed&) {};
    /// A return was clicked, or the one that was is in another scan now (then null).
    std::function<void(const view::SegmentStory*)> onPicked = [](const view::SegmentStory*) {};

 private:
    void showComposed();
    void tellOfShown();
    void showWalls();
    void follow(const Composed& composed);
    void pickAlong(const view::SightLine& line);
    std::vector<uint8_t> hiddenBy(const SceneChoices& choices) const;
    void composeAgain();

    ScanCanvas* canvas_;
    const Theme* theme_ = &Theme::darkOne();
    SceneChoices choices_;
    CameraMode cameraMode_ = CameraMode::Perspective;
    std::shared_ptr<const core::LineMap> map_;
    ComposedPtr shown_;
    std::optional<mrpt::math::TBoundingBox> wallsExtent_;  // [m] that walls were drawn for
    std::optional<mrpt::math::TPoint3D> followed_;         // [m] where the sensor stood last
    bool fitted_ = false;                                  // to what was opened
    live::LiveFramePtr pickedIn_;                          // null: nothing is picked
    wxTimer pacer_;                                        // of onShown
    std::mutex drawing_;                                   // of what the composer is to know
    live::LiveFramePtr newest_;                            // that was to be drawn
    SceneChoices composedChoices_;
    view::Palette composedPalette_;
    FrameComposer composer_;  // last: its thread ends before the rest does
};

}  // namespace offmap::window
