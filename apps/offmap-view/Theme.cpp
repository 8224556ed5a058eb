// SPDX-License-Identifier: BSD-3-Clause
#include "Theme.h"

#include <gtk/gtk.h>

namespace offmap::window {

namespace {

Theme makeDark() {
    Theme theme;
    theme.dark = true;
    theme.background = toWx(theme.palette.background);
    theme.grid = wxColour(48, 54, 64);
    theme.text = wxColour(226, 232, 240);
    theme.subtle = wxColour(138, 147, 160);
    theme.accent = wxColour(250, 204, 21);
    theme.good = wxColour(74, 201, 126);
    theme.bad = wxColour(248, 113, 113);
    theme.removed = wxColour(224, 82, 82);
    theme.timing = wxColour(96, 165, 250);
    return theme;
}

Theme makeLight() {
    Theme theme;
    theme.dark = false;
    theme.palette = view::Palette::light();
    theme.background = toWx(theme.palette.background);
    theme.grid = wxColour(220, 224, 230);
    theme.text = wxColour(30, 36, 46);
    theme.subtle = wxColour(106, 114, 126);
    theme.accent = wxColour(202, 122, 4);
    theme.good = wxColour(22, 138, 70);
    theme.bad = wxColour(200, 40, 40);
    theme.removed = wxColour(178, 24, 24);
    theme.timing = wxColour(29, 100, 216);
    return theme;
}

}  // namespace

const Theme& Theme::darkOne() {
    static const Theme theme = makeDark();
    return theme;
}

const Theme& Theme::lightOne() {
    static const Theme theme = makeLight();
    return theme;
}

wxColour toWx(const mrpt::img::TColor& colour) { return {colour.R, colour.G, colour.B, colour.A}; }

void applyToToolkit(const Theme& theme) {
    g_object_set(gtk_settings_get_default(), "gtk-application-prefer-dark-theme",
                 static_cast<gboolean>(theme.dark), nullptr);
}

}  // namespace offmap::window
