// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnPane.h"

#include <memory>
#include <wx/dcbuffer.h>

namespace offmap::window {

DrawnPane::DrawnPane(wxWindow* parent, const wxSize& smallest) : wxPanel(parent) {
    SetBackgroundStyle(wxBG_STYLE_PAINT);
    SetMinSize(FromDIP(smallest));
    Bind(wxEVT_PAINT, [this](wxPaintEvent&) { onPaint(); });
    Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
        Refresh(false);
        event.Skip();
    });
}

void DrawnPane::setTheme(const Theme& theme) {
    theme_ = &theme;
    Refresh(false);
}

void DrawnPane::onPaint() {
    wxAutoBufferedPaintDC dc(this);
    dc.SetBackground(wxBrush(theme_->background));
    dc.Clear();
    const wxSize size = GetClientSize();
    if (size.x <= 0 || size.y <= 0) return;
    const std::unique_ptr<wxGraphicsContext> canvas(wxGraphicsContext::Create(dc));
    if (canvas) draw(*canvas, size);
}

}  // namespace offmap::window
