// SPDX-License-Identifier: BSD-3-Clause
#include "Icons.h"

#include <fmt/format.h>

#include <string>

namespace offmap::window {

namespace {

/// Drawn on a field of 16 x 16.
const char* shapeOf(Icon icon) {
    switch (icon) {
        case Icon::Open:
            return "<path d='M1.5 13.5V3h4.2l1.6 1.8h7.2v8.7z' fill='none' stroke='{0}' "
                   "stroke-width='1.4' stroke-linejoin='round'/>";
        case Icon::Map:
            return "<path d='M2 14V2h12v12h-5M2 8h5M7 8v2.5M11 2v4.5' fill='none' stroke='{0}' "
                   "stroke-width='1.5'/>";
        case Icon::Live:
            return "<circle cx='8' cy='8' r='2.2' fill='{0}'/><path d='M4.2 4.2a5.4 5.4 0 0 0 0 "
                   "7.6M11.8 4.2a5.4 5.4 0 0 1 0 7.6' fill='none' stroke='{0}' "
                   "stroke-width='1.4'/>";
        case Icon::First:
            return "<path d='M3 3h2v10H3zM13 3v10L6 8z' fill='{0}'/>";
        case Icon::Back:
            return "<path d='M11 3h2v10h-2zM9.5 3v10L3 8z' fill='{0}'/>";
        case Icon::Play:
            return "<path d='M4 2.5v11L13 8z' fill='{0}'/>";
        case Icon::Pause:
            return "<path d='M4 3h3v10H4zM9 3h3v10H9z' fill='{0}'/>";
        case Icon::Forward:
            return "<path d='M3 3h2v10H3zM6.5 3v10L13 8z' fill='{0}'/>";
        case Icon::Theme:
            return "<circle cx='8' cy='8' r='5.6' fill='none' stroke='{0}' stroke-width='1.4'/>"
                   "<path d='M8 2.4a5.6 5.6 0 0 1 0 11.2z' fill='{0}'/>";
    }
    return "";
}

}  // namespace

wxBitmapBundle iconOf(Icon icon, const wxColour& colour) {
    constexpr int size = 16;  // [px]
    const std::string shape = fmt::format(fmt::runtime(shapeOf(icon)),
                                          colour.GetAsString(wxC2S_HTML_SYNTAX).ToStdString());
    const std::string picture = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{0}'>{1}</svg>", size, shape);
    return wxBitmapBundle::FromSVG(picture.c_str(), wxSize(size, size));
}

}  // namespace offmap::window
