// SPDX-License-Identifier: BSD-3-Clause
#include "Shortcuts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <wx/event.h>

namespace offmap::window {

namespace {

constexpr std::array table{
    Shortcut{Action::OpenLog, "File", "Ctrl+O", "Open a log"},
    Shortcut{Action::OpenMap, "File", "Ctrl+M", "Open a map"},
    Shortcut{Action::OpenLive, "File", "Ctrl+L", "Watch a live source"},
    Shortcut{Action::SaveScreenshot, "File", "Ctrl+S", "Save a screenshot"},
    Shortcut{Action::ExportFigure, "File", "Ctrl+E", "Export a figure"},
    Shortcut{Action::ExportTurns, "File", "Ctrl+T", "Export reduced turns"},
    Shortcut{Action::Record, "File", "Ctrl+R", "Record the reduced log"},
    Shortcut{Action::Quit, "File", "Ctrl+Q", "Quit"},
    Shortcut{Action::PlayOrPause, "Play", "Space", "Play or pause"},
    Shortcut{Action::StepForward, "Play", "Right", "Step forward"},
    Shortcut{Action::StepBack, "Play", "Left", "Step back"},
    Shortcut{Action::Faster, "Play", "+", "Faster"},
    Shortcut{Action::Slower, "Play", "-", "Slower"},
    Shortcut{Action::FirstTurn, "Play", "Home", "Go to the first turn"},
    Shortcut{Action::TopCamera, "Camera", "T", "From above"},
    Shortcut{Action::FollowCamera, "Camera", "F", "Follow the robot"},
    Shortcut{Action::PerspectiveCamera, "Camera", "P", "Perspective"},
    Shortcut{Action::ResetView, "Camera", "R", "Reset the view"},
    Shortcut{Action::ColourByLabel, "Colours", "1", "By what became of a point"},
    Shortcut{Action::ColourByHeight, "Colours", "2", "By height"},
    Shortcut{Action::ColourByIntensity, "Colours", "3", "By intensity"},
    Shortcut{Action::ColourByResidual, "Colours", "4", "By residual"},
    Shortcut{Action::ColourByReason, "Colours", "5", "By the reason to keep"},
    Shortcut{Action::ShowMapped, "View", "M", "Mapped points on or off"},
    Shortcut{Action::ShowWalls, "View", "W", "Walls on or off"},
    Shortcut{Action::ShowEllipse, "View", "E", "Pose ellipse on or off"},
    Shortcut{Action::SmallerPoints, "View", "[", "Smaller points"},
    Shortcut{Action::LargerPoints, "View", "]", "Larger points"},
    Shortcut{Action::SwitchTheme, "View", "D", "Dark or light theme"},
    Shortcut{Action::FullScreen, "View", "F11", "Full screen"},
    Shortcut{Action::ClearSelection, "View", "Esc", "Clear the selection"},
    Shortcut{Action::ShowShortcuts, "Help", "F1", "Keyboard shortcuts"},
};

/// The key as the table writes it; empty for one that it does not hold.
std::string keyText(int code) {
    switch (code) {
        case WXK_SPACE:
            return "Space";
        case WXK_RIGHT:
        case WXK_NUMPAD_RIGHT:
            return "Right";
        case WXK_LEFT:
        case WXK_NUMPAD_LEFT:
            return "Left";
        case WXK_HOME:
        case WXK_NUMPAD_HOME:
            return "Home";
        case WXK_ESCAPE:
            return "Esc";
        case WXK_F1:
            return "F1";
        case WXK_F11:
            return "F11";
        case WXK_NUMPAD_ADD:
            return "+";
        case WXK_NUMPAD_SUBTRACT:
            return "-";
        default:
            break;
    }
    if (code >= WXK_NUMPAD0 && code <= WXK_NUMPAD9) code += '0' - WXK_NUMPAD0;
    if (code <= WXK_SPACE || code >= WXK_DELETE) return {};
    return {static_cast<char>(std::toupper(code))};
}

}  // namespace

std::span<const Shortcut> shortcuts() { return table; }

const Shortcut& shortcutOf(Action action) {
    return *std::ranges::find(table, action, &Shortcut::action);
}

std::optional<Action> actionOf(const wxKeyEvent& event) {
    if (event.AltDown() || event.MetaDown()) return std::nullopt;
    std::string key = keyText(event.GetKeyCode());
    // on the main block of many keyboards, + is Shift and =
    if (key == "=" && !event.ControlDown()) key = "+";
    if (event.ControlDown()) key = "Ctrl+" + key;
    const auto found = std::ranges::find(table, key, &Shortcut::key);
    return found == table.end() ? std::nullopt : std::optional(found->action);
}

}  // namespace offmap::window
