// SPDX-License-Identifier: BSD-3-Clause
#include "ScanCanvas.h"

#include <offmap/view/MrptCamera.h>

#include <GL/gl.h>
#include <cmath>
#include <utility>

namespace offmap::window {

ScanCanvas::ScanCanvas(wxWindow* parent) : CWxGLCanvasBase(parent) {
    const auto view = getOpenGLSceneRef()->getViewport();
    view->setViewportClipDistances(0.1F, 10'000.0F);
    setUseCameraFromScene(true);
    // In this order, so that translucent walls let the others shine through.
    for (auto& part : parts_) {
        part = mrpt::opengl::CSetOfObjects::Create();
        getOpenGLSceneRef()->insert(part);
    }
    setTheme(Theme::darkOne());
    bindMouse();
}

/// Bound after the base class, so that these are asked first, and its own never.
void ScanCanvas::bindMouse() {
    const auto press = [this](wxMouseEvent& event) {
        pressedAt_ = lastAt_ = event.GetPosition();
        pressed_ = true;
        turned_ = false;
        SetFocus();
    };
    Bind(wxEVT_LEFT_DOWN, press);
    Bind(wxEVT_LEFT_DCLICK, press);
    Bind(wxEVT_RIGHT_DOWN, press);
    Bind(wxEVT_MIDDLE_DOWN, press);
    Bind(wxEVT_LEFT_UP, [this](wxMouseEvent& event) { onRelease(event); });
    Bind(wxEVT_RIGHT_UP, [this](wxMouseEvent&) { pressed_ = false; });
    Bind(wxEVT_MIDDLE_UP, [this](wxMouseEvent&) { pressed_ = false; });
    Bind(wxEVT_MOTION, [this](wxMouseEvent& event) { onMotion(event); });
    Bind(wxEVT_MOUSEWHEEL, [this](wxMouseEvent& event) { onWheel(event); });
    // The base class would take the focus from whatever is being typed into.
    Bind(wxEVT_ENTER_WINDOW, [](wxMouseEvent&) {});
}

void ScanCanvas::setPart(Part part, const mrpt::opengl::CSetOfObjects::Ptr& objects) {
    auto& place = *parts_.at(static_cast<size_t>(part));
    place.clear();
    if (objects) place.insert(objects);
    paintSoon();
}

void ScanCanvas::setTheme(const Theme& theme) {
    getOpenGLSceneRef()->getViewport()->setCustomBackgroundColor(
        mrpt::img::TColorf(theme.palette.background));
    paintSoon();
}

void ScanCanvas::setCamera(const view::Camera& camera) {
    camera_ = camera;
    getOpenGLSceneRef()->getViewport()->getCamera() = view::mrptCameraOf(camera);
    paintSoon();
}

void ScanCanvas::paintSoon() {
    if (!painting_) Refresh(false);
}

view::PictureSize ScanCanvas::pictureSize() const {
    const wxSize size = GetClientSize();
    return {static_cast<uint32_t>(std::max(1, size.x)), static_cast<uint32_t>(std::max(1, size.y))};
}

void ScanCanvas::moveTo(const view::Camera& camera) {
    setCamera(camera);
    onMoved();
}

void ScanCanvas::onMotion(const wxMouseEvent& event) {
    if (!event.Dragging() || !pressed_) return;
    const wxPoint moved = event.GetPosition() - lastAt_;
    lastAt_ = event.GetPosition();
    constexpr int tremble = 3;  // [px] that a click may move
    const wxPoint all = lastAt_ - pressedAt_;
    turned_ = turned_ || std::abs(all.x) > tremble || std::abs(all.y) > tremble;
    if (!turned_) return;
    const mrpt::math::TPoint2D by(moved.x, moved.y);
    const bool turns = event.LeftIsDown() && !event.ShiftDown() && camera_.shorterSide == 0;
    moveTo(turns ? view::orbited(camera_, by) : view::panned(camera_, by, pictureSize()));
}

void ScanCanvas::onRelease(const wxMouseEvent& event) {
    // A button that was pressed in a dialog is released here when the dialog has gone.
    if (!std::exchange(pressed_, false) || turned_) return;
    onClick(view::sightLine(camera_, {double(event.GetX()), double(event.GetY())}, pictureSize()));
}

void ScanCanvas::onWheel(const wxMouseEvent& event) {
    constexpr double perNotch = 0.85;
    const double notches = double(event.GetWheelRotation()) / event.GetWheelDelta();
    moveTo(view::zoomed(camera_, std::pow(perNotch, notches),
                        {double(event.GetX()), double(event.GetY())}, pictureSize()));
}

wxImage ScanCanvas::picture() {
    wanted_ = true;
    Refresh(false);
    Update();
    wanted_ = false;  // nothing is painted while it is not shown
    return std::exchange(picture_, wxImage());
}

void ScanCanvas::OnPreRender() {
    painting_ = true;
    onPaint();
    painting_ = false;
}

void ScanCanvas::OnPostRender() {
    if (!std::exchange(wanted_, false)) return;
    const auto size = pictureSize();
    picture_.Create(static_cast<int>(size.width), static_cast<int>(size.height), false);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height), GL_RGB,
                 GL_UNSIGNED_BYTE, picture_.GetData());
    picture_ = picture_.Mirror(false);  // OpenGL counts rows from below
}

void ScanCanvas::OnPostRenderSwapBuffers(double, wxPaintDC&) { onPainted(); }

}  // namespace offmap::window
