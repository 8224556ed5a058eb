// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

class wxKeyEvent;

namespace offmap::window {

/// What a key or a line of a menu does.
enum class Action : uint8_t {
    OpenLog,
    OpenMap,
    OpenLive,
    SaveScreenshot,
    ExportFigure,
    ExportTurns,
    Record,
    Quit,
    PlayOrPause,
    StepForward,
    StepBack,
    Faster,
    Slower,
    FirstTurn,
    TopCamera,
    FollowCamera,
    PerspectiveCamera,
    ResetView,
    ColourByLabel,
    ColourByHeight,
    ColourByIntensity,
    ColourByResidual,
    ColourByReason,
    ShowMapped,
    ShowWalls,
    ShowEllipse,
    SmallerPoints,
    LargerPoints,
    SwitchTheme,
    FullScreen,
    ClearSelection,
    ShowShortcuts,
};

struct Shortcut {
    Action action;
    const char* group;
    const char* key;  ///< "Ctrl+O", as a menu writes it behind a tab
    const char* meaning;
};

/// Group by group, one of each action in the order of Action.
std::span<const Shortcut> shortcuts();

const Shortcut& shortcutOf(Action action);

/// What a key stands for; none where the focus is in a field that one types into is the caller's
/// to find out.
std::optional<Action> actionOf(const wxKeyEvent& event);

}  // namespace offmap::window
