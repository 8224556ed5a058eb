// SPDX-License-Identifier: BSD-3-Clause
#include "Lettering.h"

#include <cmath>

namespace offmap::window {

wxFont smallFont(const wxWindow& window) { return window.GetFont().Scaled(0.85F); }

wxSize extentOf(wxGraphicsContext& canvas, const std::string& text) {
    double width = 0, height = 0;
    canvas.GetTextExtent(wxString::FromUTF8(text), &width, &height);
    return {static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(height))};
}

void drawText(wxGraphicsContext& canvas, const std::string& text, double x, double y,
              Beside beside) {
    const wxSize extent = extentOf(canvas, text);
    const double share = beside == Beside::Right ? 0 : beside == Beside::Left ? 1 : 0.5;
    // On whole pixels letters are sharp.
    canvas.DrawText(wxString::FromUTF8(text), std::round(x - share * extent.x),
                    std::round(y - 0.5 * extent.y));
}

}  // namespace offmap::window
