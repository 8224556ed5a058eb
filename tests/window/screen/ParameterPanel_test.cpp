// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterPanel.h"

#include "../../support/ParameterValues.h"
#include "WxText.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/ParameterTable.h>

#include <gmock/gmock.h>

#include <wx/button.h>
#include <wx/checkbox.h>
#include <wx/choice.h>
#include <wx/frame.h>
#include <wx/srchctrl.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

class ParameterPanelTest : public testing::Test {
 protected:
    ParameterPanelTest()
        : frame_(new wxFrame(nullptr, wxID_ANY, "")), panel(*new ParameterPanel(frame_)) {
        panel.onChange = [this](const rawlog::Config&) { ++changes; };
        panel.onError = [this](const std::string& text) { error = text; };
        frame_->Show();
    }
    ~ParameterPanelTest() override { delete frame_; }

    wxWindow& control(std::string_view key) const {
        wxWindow* found = wxWindow::FindWindowByName(toWx(key), &panel);
        if (found == nullptr) throw std::logic_error("no control of " + std::string(key));
        return *found;
    }
    wxTextCtrl& field(std::string_view key) const {
        return dynamic_cast<wxTextCtrl&>(control(key));
    }
    /// What a control shows, as a file would say it.
    std::string shown(std::string_view key) const {
        wxWindow& window = control(key);
        if (const auto* box = dynamic_cast<wxCheckBox*>(&window))
            return box->GetValue() ? "true" : "false";
        if (const auto* choice = dynamic_cast<wxChoice*>(&window))
            return fromWx(choice->GetStringSelection());
        return fromWx(field(key).GetValue());
    }
    /// As a user types into a field and presses Enter.
    void type(std::string_view key, const char* text) const {
        field(key).ChangeValue(text);
        send(field(key), wxEVT_TEXT_ENTER);
    }
    static void send(wxWindow& window, wxEventType type, const char* text = "", int number = 0) {
        wxCommandEvent event(type, window.GetId());
        event.SetString(text);
        event.SetInt(number);
        window.GetEventHandler()->ProcessEvent(event);
    }
    void press(std::string_view key, int keyCode, bool shift = false) const {
        wxKeyEvent event(wxEVT_KEY_DOWN);
        event.m_keyCode = keyCode;
        event.SetShiftDown(shift);
        field(key).GetEventHandler()->ProcessEvent(event);
    }
    std::string valueOf(std::string_view key) const {
        return rawlog::findParameter(key).text(panel.config());
    }
    /// The last one of this label in a window.
    static wxButton* button(const wxWindow& window, const wxString& label) {
        wxButton* found = nullptr;
        for (wxWindow* child : window.GetChildren()) {
            auto* one = dynamic_cast<wxButton*>(child);
            if (one != nullptr && one->GetLabel() == label) found = one;
        }
        return found;
    }

 private:
    wxFrame* frame_;

 protected:
    ParameterPanel& panel;
    int changes = 0;
    std::string error;
};

}  // namespace

TEST_F(ParameterPanelTest, showsEveryParameterAtBothLimits) {
    for (const rawlog::Parameter& p : rawlog::parameters()) {
        for (const auto& limit : test::limitsOf(p)) {
            rawlog::Config config;
            p.setNumbers(config, limit);
            panel.setConfig(config);
            EXPECT_EQ(shown(p.key), p.text(config));
        }
    }
    EXPECT_EQ(changes, 0);
}

TEST_F(ParameterPanelTest, enteredTextChangesTheConfiguration) {
    type("vertical.max_tilt_deg", " 4.125 ");
    EXPECT_EQ(valueOf("vertical.max_tilt_deg"), "4.125");
    type("sensor.elevations_deg", "-1,1");
    EXPECT_EQ(valueOf("sensor.elevations_deg"), "[-1, 1]");
    EXPECT_EQ(shown("sensor.elevations_deg"), "[-1, 1]");
    EXPECT_EQ(changes, 2);
    EXPECT_EQ(error, "");
}

TEST_F(ParameterPanelTest, theSameTextChangesNothing) {
    type("vertical.max_tilt_deg", "5 ");
    EXPECT_EQ(shown("vertical.max_tilt_deg"), "5");
    EXPECT_EQ(changes, 0);
}

TEST_F(ParameterPanelTest, whatIsNotAllowedTurnsBackAndSaysWhatIs) {
    for (const char* text : {"46", "0", "nan", "steep", "", "5 deg"}) {
        error.clear();
        type("vertical.max_tilt_deg", text);
        EXPECT_EQ(shown("vertical.max_tilt_deg"), "5") << text;
        EXPECT_THAT(error, testing::HasSubstr("0.1 ... 45 deg")) << text;
    }
    type("sensor.robot_box_m", "[1, -1, 0, 1, 0, 1]");  // its x_min above its x_max
    EXPECT_EQ(shown("sensor.robot_box_m"), "[]");
    EXPECT_THAT(error, testing::HasSubstr("robot_box"));
    EXPECT_EQ(changes, 0);
}

TEST_F(ParameterPanelTest, leavingAFieldEntersItsText) {
    field("vertical.min_points").ChangeValue("6");
    wxFocusEvent left(wxEVT_KILL_FOCUS);
    field("vertical.min_points").GetEventHandler()->ProcessEvent(left);
    EXPECT_EQ(valueOf("vertical.min_points"), "6");
}

TEST_F(ParameterPanelTest, arrowKeysStepAndEscapeTurnsBack) {
    press("vertical.max_point_to_line_m", WXK_UP);
    press("vertical.max_point_to_line_m", WXK_UP);
    EXPECT_EQ(valueOf("vertical.max_point_to_line_m"), "0.07");
    press("vertical.max_point_to_line_m", WXK_DOWN, true);
    EXPECT_EQ(valueOf("vertical.max_point_to_line_m"), "0.001");
    field("vertical.max_point_to_line_m").ChangeValue("7");
    press("vertical.max_point_to_line_m", WXK_ESCAPE);
    EXPECT_EQ(shown("vertical.max_point_to_line_m"), "0.001");
    EXPECT_EQ(changes, 3);
}

TEST_F(ParameterPanelTest, switchesAndChoicesActAtOnce) {
    send(control("extension.enabled"), wxEVT_CHECKBOX, "", 0);
    EXPECT_FALSE(panel.config().reduction.extension.enabled);
    send(control("matching.method"), wxEVT_CHOICE, "paper");
    EXPECT_EQ(panel.config().reduction.matching.method, core::MatchingMethod::Paper);
    EXPECT_EQ(changes, 2);
}

TEST_F(ParameterPanelTest, resetTakesBackOneParameterOrAllOfThem) {
    rawlog::Config config;
    rawlog::applySetting(config, "sensors.FRONT.min_range_m=0.5");
    panel.setConfig(config);
    type("vertical.max_tilt_deg", "4");
    type("vertical.min_points", "7");
    // the last one of its section is of min_points
    wxButton* reset = button(*control("vertical.min_points").GetParent(), toWx("↺"));
    ASSERT_NE(reset, nullptr);
    EXPECT_TRUE(reset->IsEnabled());
    send(*reset, wxEVT_BUTTON);
    EXPECT_FALSE(reset->IsEnabled());
    EXPECT_EQ(valueOf("vertical.min_points"), "4");
    EXPECT_EQ(valueOf("vertical.max_tilt_deg"), "4");

    send(*button(panel, "Reset all"), wxEVT_BUTTON);
    EXPECT_EQ(valueOf("vertical.max_tilt_deg"), "5");
    EXPECT_EQ(panel.config().sensors.size(), 1);
    EXPECT_EQ(changes, 4);
}

TEST_F(ParameterPanelTest, theFilterShowsWhatItFindsInFoldedSectionsToo) {
    wxSearchCtrl* filter = nullptr;
    for (wxWindow* child : panel.GetChildren()) {
        if (filter == nullptr) filter = dynamic_cast<wxSearchCtrl*>(child);
    }
    ASSERT_NE(filter, nullptr);
    EXPECT_FALSE(control("map.sigma_m").IsShownOnScreen());
    filter->SetValue("sigma wall");
    EXPECT_TRUE(control("map.sigma_m").IsShownOnScreen());
    EXPECT_FALSE(control("vertical.max_tilt_deg").IsShownOnScreen());
    filter->SetValue("");
    EXPECT_FALSE(control("map.sigma_m").IsShownOnScreen());
    EXPECT_TRUE(control("vertical.max_tilt_deg").IsShownOnScreen());
}

}  // namespace offmap::window
