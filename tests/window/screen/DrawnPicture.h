// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <wx/dcmemory.h>
#include <wx/frame.h>
#include <wx/graphics.h>
#include <wx/image.h>
#include <wx/panel.h>

namespace offmap::test {

/// The pixels of one colour in a picture.
struct Spot {
    int count = 0;
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;  ///< [px] of the outermost

    double middleX() const { return 0.5 * (left + right); }
    double middleY() const { return 0.5 * (top + bottom); }
};

inline bool hasColour(const wxImage& picture, int x, int y, const wxColour& colour) {
    // Drawn as it is, without smooth edges: but for rounding when it is blended with itself.
    constexpr int rounding = 2;
    return std::abs(picture.GetRed(x, y) - colour.Red()) <= rounding &&
           std::abs(picture.GetGreen(x, y) - colour.Green()) <= rounding &&
           std::abs(picture.GetBlue(x, y) - colour.Blue()) <= rounding;
}

/// \param within [px] the part that is looked at
inline Spot spotOf(const wxImage& picture, const wxColour& colour, const wxRect& within) {
    Spot spot;
    for (int y = within.GetTop(); y <= within.GetBottom(); ++y) {
        for (int x = within.GetLeft(); x <= within.GetRight(); ++x) {
            if (!hasColour(picture, x, y, colour)) continue;
            ++spot.count;
            spot.left = std::min(spot.left, x);
            spot.right = std::max(spot.right, x);
            spot.top = std::min(spot.top, y);
            spot.bottom = std::max(spot.bottom, y);
        }
    }
    return spot;
}

inline Spot spotOf(const wxImage& picture, const wxColour& colour) {
    return spotOf(picture, colour, {0, 0, picture.GetWidth(), picture.GetHeight()});
}

/// A pane in a window on the screen, of that size.
template <class Pane>
class PaneOnScreen {
    struct Opened : Pane {
        using Pane::draw;
        using Pane::Pane;
        using Pane::theme;
    };

 public:
    PaneOnScreen(int width, int height)
        : frame_(new wxFrame(nullptr, wxID_ANY, "pane", wxDefaultPosition, {900, 500})),
          pane_(new Opened(new wxPanel(frame_))) {
        frame_->Show();
        pane_->SetSize(0, 0, width, height);
        wxYield();
    }
    ~PaneOnScreen() {
        delete frame_;  // not Destroy(), which waits for a loop of events
    }
    PaneOnScreen(const PaneOnScreen&) = delete;
    PaneOnScreen& operator=(const PaneOnScreen&) = delete;

    Pane& operator*() { return *pane_; }
    Pane* operator->() { return pane_; }

    /// As it is drawn now.
    wxImage picture() {
        const wxSize size = pane_->GetClientSize();
        wxBitmap bitmap(size.x, size.y, 24);
        {
            wxMemoryDC dc(bitmap);
            dc.SetBackground(wxBrush(pane_->theme().background));
            dc.Clear();
            const std::unique_ptr<wxGraphicsContext> canvas(wxGraphicsContext::Create(dc));
            pane_->draw(*canvas, size);
        }
        return bitmap.ConvertToImage();
    }

    void mouse(const wxEventTypeTag<wxMouseEvent>& type, int x, int y, bool leftDown = false) {
        wxMouseEvent event(type);
        event.SetPosition({x, y});
        event.SetLeftDown(leftDown);
        pane_->GetEventHandler()->ProcessEvent(event);
    }
    /// \param notches of the wheel, forwards
    void wheel(int notches, int x, int y) {
        wxMouseEvent event(wxEVT_MOUSEWHEEL);
        event.SetPosition({x, y});
        event.m_wheelDelta = 120;
        event.m_wheelRotation = 120 * notches;
        pane_->GetEventHandler()->ProcessEvent(event);
    }
    void key(int code) {
        wxKeyEvent event(wxEVT_KEY_DOWN);
        event.m_keyCode = code;
        pane_->GetEventHandler()->ProcessEvent(event);
    }

 private:
    wxFrame* frame_;
    Opened* pane_;
};

}  // namespace offmap::test
