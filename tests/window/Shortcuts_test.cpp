// SPDX-License-Identifier: BSD-3-Clause
#include "Shortcuts.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <wx/event.h>

namespace offmap::window {

namespace {

std::optional<Action> pressed(int key, bool control = false, bool alt = false) {
    wxKeyEvent event(wxEVT_CHAR_HOOK);
    event.m_keyCode = key;
    event.SetControlDown(control);
    event.SetAltDown(alt);
    return actionOf(event);
}

}  // namespace

TEST(Shortcuts, everyActionHasOneKeyOfItsOwn) {
    std::set<std::string> keys;
    size_t place = 0;
    for (const Shortcut& shortcut : shortcuts()) {
        EXPECT_EQ(static_cast<size_t>(shortcut.action), place++) << shortcut.meaning;
        EXPECT_TRUE(keys.insert(shortcut.key).second) << shortcut.key;
    }
    EXPECT_EQ(place, static_cast<size_t>(Action::ShowShortcuts) + 1);
    EXPECT_STREQ(shortcutOf(Action::Record).key, "Ctrl+R");
}

TEST(Shortcuts, keysOfTheKeyboardAreUnderstood) {
    EXPECT_EQ(pressed(WXK_SPACE), Action::PlayOrPause);
    EXPECT_EQ(pressed(WXK_NUMPAD_LEFT), Action::StepBack);
    EXPECT_EQ(pressed('='), Action::Faster);
    EXPECT_EQ(pressed(WXK_NUMPAD_SUBTRACT), Action::Slower);
    EXPECT_EQ(pressed('r'), Action::ResetView);
    EXPECT_EQ(pressed('R', true), Action::Record);
    EXPECT_EQ(pressed(WXK_NUMPAD3), Action::ColourByIntensity);
    EXPECT_EQ(pressed('['), Action::SmallerPoints);
    EXPECT_EQ(pressed(WXK_F11), Action::FullScreen);
    EXPECT_EQ(pressed(WXK_ESCAPE), Action::ClearSelection);
}

TEST(Shortcuts, otherKeysMeanNothing) {
    EXPECT_FALSE(pressed('Z'));
    EXPECT_FALSE(pressed(WXK_F5));
    EXPECT_FALSE(pressed('R', true, true));
    EXPECT_FALSE(pressed('=', true));
    EXPECT_FALSE(pressed(0));
    EXPECT_FALSE(pressed(0x410));
}

}  // namespace offmap::window
