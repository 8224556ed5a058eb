// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Theme.h"

#include <wx/graphics.h>
#include <wx/panel.h>

namespace offmap::window {

/// A pane that draws itself in the colours of a theme, without flicker.
class DrawnPane : public wxPanel {
 public:
    DrawnPane(wxWindow* parent, const wxSize& smallest);

    virtual void setTheme(const Theme& theme);

 protected:
    /// The background is drawn already. All [px].
    virtual void draw(wxGraphicsContext& canvas, const wxSize& size) = 0;

    const Theme& theme() const { return *theme_; }

 private:
    void onPaint();

    const Theme* theme_ = &Theme::darkOne();
};

}  // namespace offmap::window
