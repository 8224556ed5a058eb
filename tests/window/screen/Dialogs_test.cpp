// SPDX-License-Identifier: BSD-3-Clause
#include "HelpDialogs.h"
#include "LiveDialog.h"
#include "Shortcuts.h"
#include "VerdictPane.h"
#include "WindowIcon.h"
#include "WxText.h"

#include <gmock/gmock.h>

#include <wx/frame.h>
#include <wx/stattext.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

/// All text that stands in a window.
std::string textIn(const wxWindow& window) {
    std::string text;
    for (wxWindow* child : window.GetChildren()) {
        if (const auto* label = dynamic_cast<wxStaticText*>(child)) {
            text += fromWx(label->GetLabel()) + '\n';
        }
        if (const auto* field = dynamic_cast<wxTextCtrl*>(child)) {
            text += fromWx(field->GetValue()) + '\n';
        }
        text += textIn(*child);
    }
    return text;
}

class DialogTest : public testing::Test {
 protected:
    DialogTest() : frame(new wxFrame(nullptr, wxID_ANY, "")) {}
    ~DialogTest() override { delete frame; }

    wxFrame* frame;
};

}  // namespace

TEST_F(DialogTest, verdictIsASentenceAboveNamesAndValues) {
    auto* pane = new VerdictPane(frame);
    EXPECT_THAT(textIn(*pane), testing::HasSubstr("Click a point"));
    pane->show({{"wall", "17"}, {"measured", "2.31 m ± 0.04 m"}}, "Removed: it stands on a wall.");
    EXPECT_EQ(textIn(*pane),
              "Removed: it stands on a wall.\n\nwall\t17\nmeasured\t2.31 m ± 0.04 m\n\n");
    pane->setTheme(Theme::lightOne());
    EXPECT_THAT(textIn(*pane), testing::HasSubstr("2.31 m ± 0.04 m"));
    pane->clear();
    EXPECT_THAT(textIn(*pane), testing::HasSubstr("Click a point"));
    EXPECT_THAT(textIn(*pane), testing::Not(testing::HasSubstr("wall")));
}

TEST_F(DialogTest, allShortcutsAreShown) {
    const ShortcutsDialog dialog(frame);
    const std::string text = textIn(dialog);
    for (const Shortcut& shortcut : shortcuts()) {
        EXPECT_THAT(text, testing::HasSubstr(std::string(shortcut.key) + '\n' + shortcut.meaning));
    }
}

TEST_F(DialogTest, liveSourceBeginsWithWhatWasEnteredLast) {
    const LiveEntries before{
        LiveKind::Capture, "2369", "/logs/a.pcap", "TOP", LivePoseKind::Fixed, "1", "2", "3"};
    const LiveDialog dialog(frame, before, Theme::lightOne());
    const LiveEntries after = dialog.entries();
    EXPECT_EQ(after.kind, LiveKind::Capture);
    EXPECT_EQ(after.poses, LivePoseKind::Fixed);
    EXPECT_EQ(after.port + after.file + after.label, "2369/logs/a.pcapTOP");
    EXPECT_EQ(after.x + after.y + after.yaw, "123");
}

TEST_F(DialogTest, iconIsDrawnInAllSizes) {
    const wxIconBundle icons = windowIcon();
    EXPECT_EQ(icons.GetIconCount(), 5);
    const wxImage image = wxBitmap(icons.GetIcon(wxSize(128, 128))).ConvertToImage();
    // the wall of the drawing is #60a5fa
    EXPECT_EQ(image.GetRed(101, 100), 0x60);
    EXPECT_EQ(image.GetGreen(101, 100), 0xa5);
    EXPECT_EQ(image.GetBlue(101, 100), 0xfa);
}

}  // namespace offmap::window
