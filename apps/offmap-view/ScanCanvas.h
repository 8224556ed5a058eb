// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Theme.h"

#include <offmap/view/CameraMotion.h>

#include <mrpt/gui/CWxGLCanvasBase.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <functional>
#include <wx/image.h>

namespace offmap::window {

/// The 3D picture. Dragging turns the camera, with the right or middle button it shifts it; the
/// wheel comes nearer to what is under the pointer.
class ScanCanvas : public mrpt::gui::CWxGLCanvasBase {
 public:
    explicit ScanCanvas(wxWindow* parent);

    /// What the scene is made of; null takes a part out. Objects must not have been drawn by
    /// another canvas.
    enum class Part : uint8_t { Cloud, Poses, Marks, Walls };
    void setPart(Part part, const mrpt::opengl::CSetOfObjects::Ptr& objects);

    void setTheme(const Theme& theme);
    void setCamera(const view::Camera& camera);
    const view::Camera& camera() const { return camera_; }
    view::PictureSize pictureSize() const;

    /// What is on the screen; not OK if nothing is.
    wxImage picture();

    /// A click that did not turn the camera.
    std::function<void(const view::SightLine&)> onClick = [](const view::SightLine&) {};
    /// The camera was moved by hand.
    std::function<void()> onMoved = [] {};
    /// The picture is about to be painted. Parts that are set now, and the camera, are in it.
    std::function<void()> onPaint = [] {};
    /// The picture is on the screen.
    std::function<void()> onPainted = [] {};

 private:
    void OnCharCustom(wxKeyEvent& event) override { event.Skip(); }
    void OnPreRender() override;
    void OnPostRender() override;
    void OnPostRenderSwapBuffers(double seconds, wxPaintDC& dc) override;

    void bindMouse();
    void onMotion(const wxMouseEvent& event);
    void onRelease(const wxMouseEvent& event);
    void onWheel(const wxMouseEvent& event);
    void moveTo(const view::Camera& camera);
    void paintSoon();

    static constexpr size_t partCount = 4;
    std::array<mrpt::opengl::CSetOfObjects::Ptr, partCount> parts_;
    view::Camera camera_;
    wxPoint pressedAt_, lastAt_;  // [px]
    bool pressed_ = false;        // a button, while the pointer was on the picture
    bool turned_ = false;         // since then
    bool painting_ = false;
    bool wanted_ = false;  // a picture
    wxImage picture_;
};

}  // namespace offmap::window
