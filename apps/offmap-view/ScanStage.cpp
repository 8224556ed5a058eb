// SPDX-License-Identifier: BSD-3-Clause
#include "ScanStage.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/view/Picking.h>
#include <offmap/view/SegmentMarks.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <wx/sizer.h>

namespace offmap::window {

namespace {

using mrpt::math::TBoundingBox;
using mrpt::math::TPoint3D;

constexpr int pause = 50;                                    // [ms] between calls of onShown
constexpr double usualAzimuth = -2.1, usualElevation = 0.6;  // [rad] of a camera
const mrpt::poses::CPose3D nowhere;                          // places columns without a pose

TBoundingBox boundsOf(const core::LineMap& map) {
    constexpr double ceiling = 2.5;  // [m] of a map that does not tell heights
    TBoundingBox box = TBoundingBox::PlusMinusInfinity();
    for (const core::Wall& wall : map.walls()) {
        const auto [low, high] = core::boundsOf(wall);
        box.updateWithPoint({low.x, low.y, 0});
        box.updateWithPoint({high.x, high.y, ceiling});
    }
    return box;
}

bool holds(const TBoundingBox& outer, const TBoundingBox& inner) {
    return outer.containsPoint(inner.min) && outer.containsPoint(inner.max);
}

}  // namespace

ScanStage::ScanStage(wxWindow* parent)
    : wxPanel(parent),
      canvas_(new ScanCanvas(this)),
      map_(std::make_shared<core::LineMap>(std::vector<core::Wall>())),
      pacer_(this),
      composer_([this] { CallAfter([this] { canvas_->Refresh(false); }); }) {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(canvas_, 1, wxEXPAND);
    SetSizer(sizer);
    canvas_->onPaint = [this] { showComposed(); };
    Bind(wxEVT_TIMER, [this](wxTimerEvent&) { tellOfShown(); });
    canvas_->onClick = [this](const view::SightLine& line) { pickAlong(line); };
}

void ScanStage::setMap(std::shared_ptr<const core::LineMap> map) {
    map_ = std::move(map);
    wallsExtent_.reset();
    fitted_ = false;
    clear();
    showWalls();
    if (!map_->walls().empty()) resetView();
    fitted_ = false;  // the first scan tells better what is worth looking at
}

void ScanStage::take(const live::LiveFramePtr& frame) {
    const std::lock_guard lock(drawing_);
    newest_ = frame;
    composer_.compose(frame, composedChoices_, composedPalette_);
}

void ScanStage::clear() {
    {
        const std::lock_guard lock(drawing_);
        newest_.reset();
        composer_.clear();
    }
    shown_.reset();
    followed_.reset();
    canvas_->setPart(ScanCanvas::Part::Cloud, nullptr);
    canvas_->setPart(ScanCanvas::Part::Poses, nullptr);
    clearSelection();
}

void ScanStage::composeAgain() {
    const std::lock_guard lock(drawing_);
    composedChoices_ = choices_;
    composedPalette_ = theme_->palette;
    // Not what is shown: a newer one may be on its way.
    if (newest_) composer_.compose(newest_, composedChoices_, composedPalette_);
}

void ScanStage::setTheme(const Theme& theme) {
    theme_ = &theme;
    canvas_->setTheme(theme);
    wallsExtent_.reset();
    showWalls();
    composeAgain();
}

void ScanStage::setChoices(const SceneChoices& choices) {
    choices_ = choices;
    wallsExtent_.reset();
    showWalls();
    composeAgain();
}

/// Just before the canvas is painted: the picture is of the newest scan, even while the camera is
/// turned so quickly that the toolkit comes to nothing else than to paint. Nothing but the canvas
/// may be changed meanwhile.
void ScanStage::showComposed() {
    const ComposedPtr composed = composer_.take();
    if (!composed) return;
    const bool sameScan = shown_ && shown_->frame == composed->frame;
    shown_ = composed;
    canvas_->setPart(ScanCanvas::Part::Cloud, composed->cloud);
    canvas_->setPart(ScanCanvas::Part::Poses, composed->poses);
    showWalls();
    if (!fitted_) resetView();
    follow(*composed);
    if (!sameScan) canvas_->setPart(ScanCanvas::Part::Marks, nullptr);
    if (!pacer_.IsRunning()) pacer_.StartOnce(pause);
}

void ScanStage::tellOfShown() {
    if (!shown_) return;
    if (pickedIn_ && pickedIn_ != shown_->frame) clearSelection();
    onShown(*shown_);
}

/// Walls are drawn about what is seen; as long as that stays within, they stay.
void ScanStage::showWalls() {
    if (map_->walls().empty() || !choices_.shown.walls) {
        return canvas_->setPart(ScanCanvas::Part::Walls, nullptr);
    }
    const TBoundingBox seen = shown_ ? shown_->extent : boundsOf(*map_);
    if (wallsExtent_ && holds(*wallsExtent_, seen)) return;
    TBoundingBox wide = seen;
    const double margin = 0.5 * std::max(seen.max.x - seen.min.x, seen.max.y - seen.min.y);
    wide.min = wide.min - TPoint3D(margin, margin, 0);
    wide.max = wide.max + TPoint3D(margin, margin, 0);
    canvas_->setPart(ScanCanvas::Part::Walls,
                     view::wallsOf(*map_, wide, sceneOptionsOf(choices_, theme_->palette)));
    // Heights differ from scan to scan; walls need not follow that.
    wide.min.z -= 1;
    wide.max.z += 1;
    wallsExtent_ = wide;
}

void ScanStage::resetView() {
    const auto size = canvas_->pictureSize();
    const double aspect = double(size.width) / size.height;
    if (!shown_ && map_->walls().empty()) return;
    const TBoundingBox extent = shown_ ? shown_->extent : boundsOf(*map_);
    setCamera(cameraMode_ == CameraMode::Top
                  ? view::Camera::top(extent, aspect)
                  : view::Camera::perspective(extent, aspect, usualAzimuth, usualElevation));
    fitted_ = true;
}

void ScanStage::setCameraMode(CameraMode mode) {
    const bool wasTop = cameraMode_ == CameraMode::Top;
    cameraMode_ = mode;
    followed_.reset();
    if (wasTop != (mode == CameraMode::Top)) resetView();
    if (shown_) follow(*shown_);
}

/// The camera goes with the sensor, and stays where the hand has turned it to.
void ScanStage::follow(const Composed& composed) {
    const auto& path = composed.returns.sensorPath;
    if (cameraMode_ != CameraMode::Follow || path.empty()) return;
    const auto& sensor = path[path.size() / 2];
    const TPoint3D place(sensor.x(), sensor.y(), sensor.z());
    view::Camera moved = camera();
    moved.target = followed_ ? moved.target + (place - *followed_) : place;
    followed_ = place;
    setCamera(moved);
}

void ScanStage::lookAt(const mrpt::math::TPoint2D& place) {
    view::Camera moved = camera();
    moved.target.x = place.x;
    moved.target.y = place.y;
    setCamera(moved);
}

void ScanStage::clearSelection() {
    pickedIn_.reset();
    canvas_->setPart(ScanCanvas::Part::Marks, nullptr);
    onPicked(nullptr);
}

std::vector<uint8_t> ScanStage::hiddenBy(const SceneChoices& choices) const {
    return view::hiddenReturns(shown_->returns, sceneOptionsOf(choices, theme_->palette));
}

void ScanStage::pickAlong(const view::SightLine& line) {
    if (!shown_) return;
    constexpr double reach = 5;  // [px] beside a return that still means it
    const auto size = canvas_->pictureSize();
    const double perPixel = view::metresPerPixel(camera(), size);
    const bool parallel = camera().shorterSide > 0;
    const view::ViewRay ray{line.origin, line.direction,
                            parallel ? 0 : std::atan(reach * perPixel / camera().distance),
                            parallel ? reach * perPixel : 0};
    SceneChoices sought = choices_;
    sought.shown.rest = false;  // what lies on a segment is rather meant than floor and ceiling
    auto picked = view::pick(shown_->returns, ray, hiddenBy(sought));
    if (!picked) picked = view::pick(shown_->returns, ray, hiddenBy(choices_));
    if (!picked) return clearSelection();
    const live::LiveFrame& frame = *shown_->frame;
    const core::OrganizedScan& scan = shown_->scan;
    const auto story = view::storyOf(scan, frame.result, shown_->returns.indices[*picked]);
    canvas_->setPart(ScanCanvas::Part::Marks,
                     story.segment ? view::segmentMarksOf(scan, frame.result, *map_, *story.segment,
                                                          theme_->palette, nowhere)
                                   : nullptr);
    pickedIn_ = shown_->frame;
    onPicked(&story);
}

}  // namespace offmap::window
