// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Palette.h>

#include <wx/colour.h>

namespace offmap::window {

/// The colours of everything that the window draws itself. Controls take theirs from the toolkit,
/// which applyToToolkit() tells whether they are to be dark.
struct Theme {
    bool dark = true;
    wxColour background;  ///< of what is drawn
    wxColour grid;        ///< lines that help the eye
    wxColour text;
    wxColour subtle;           ///< text that matters less
    wxColour accent;           ///< the place in the log, the robot
    wxColour good, bad;        ///< fits, does not fit
    wxColour removed, timing;  ///< curves: removed share, milliseconds
    view::Palette palette;     ///< of scan and map

    static const Theme& darkOne();
    static const Theme& lightOne();
};

wxColour toWx(const mrpt::img::TColor& colour);

/// Buttons, lists and menus become dark or light. Only with a screen.
void applyToToolkit(const Theme& theme);

}  // namespace offmap::window
