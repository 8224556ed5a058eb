// SPDX-License-Identifier: BSD-3-Clause
#include "ControlBar.h"

#include "Icons.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <wx/bmpbuttn.h>
#include <wx/choice.h>
#include <wx/sizer.h>
#include <wx/slider.h>
#include <wx/statline.h>
#include <wx/stattext.h>

namespace offmap::window {

namespace {

constexpr std::array cameras{Action::PerspectiveCamera, Action::FollowCamera, Action::TopCamera};
constexpr std::array colours{Action::ColourByLabel, Action::ColourByHeight,
                             Action::ColourByIntensity, Action::ColourByResidual,
                             Action::ColourByReason};
constexpr double pointSteps = 2;  // of the slider per [px]

Icon iconOfAction(Action action) {
    switch (action) {
        case Action::OpenLog:
            return Icon::Open;
        case Action::OpenMap:
            return Icon::Map;
        case Action::OpenLive:
            return Icon::Live;
        case Action::FirstTurn:
            return Icon::First;
        case Action::StepBack:
            return Icon::Back;
        case Action::StepForward:
            return Icon::Forward;
        case Action::SwitchTheme:
            return Icon::Theme;
        default:
            return Icon::Play;
    }
}

wxString speedText(double factor) {
    return std::isinf(factor) ? wxString("max") : wxString(fmt::format("x{:g}", factor));
}

wxString tipOf(Action action) {
    const Shortcut& shortcut = shortcutOf(action);
    return wxString::Format("%s (%s)", shortcut.meaning, shortcut.key);
}

}  // namespace

ControlBar::ControlBar(wxWindow* parent) : wxPanel(parent) {
    SetSizer(new wxBoxSizer(wxHORIZONTAL));
    for (const Action action : {Action::OpenLog, Action::OpenMap, Action::OpenLive}) {
        addButton(action, tipOf(action));
    }
    GetSizer()->AddSpacer(FromDIP(10));
    buildPlayControls();
    GetSizer()->AddStretchSpacer();
    buildViewControls();
    setTheme(*theme_);
    setPlace({}, 0);
    setPlaying(false, false);
}

wxBitmapButton* ControlBar::addButton(Action action, const wxString& tip) {
    auto* button = new wxBitmapButton(this, wxID_ANY, iconOf(Icon::Play, *wxBLACK));
    button->SetToolTip(tip);
    button->Bind(wxEVT_BUTTON, [this, action](wxCommandEvent&) { onAction(action); });
    GetSizer()->Add(button, 0, wxALL | wxALIGN_CENTER_VERTICAL, FromDIP(2));
    buttons_.push_back({button, action});
    return button;
}

wxChoice* ControlBar::addChoice(const std::vector<wxString>& texts, const wxString& tip) {
    auto* choice = new wxChoice(this, wxID_ANY);
    for (const wxString& text : texts) choice->Append(text);
    choice->SetSelection(0);
    choice->SetToolTip(tip);
    GetSizer()->Add(choice, 0, wxALL | wxALIGN_CENTER_VERTICAL, FromDIP(2));
    return choice;
}

void ControlBar::buildPlayControls() {
    for (const Action action :
         {Action::FirstTurn, Action::StepBack, Action::PlayOrPause, Action::StepForward}) {
        addButton(action, tipOf(action));
    }
    playButton_ = buttons_[buttons_.size() - 2].control;
    std::vector<wxString> texts;
    for (const double factor : speeds_) texts.push_back(speedText(factor));
    speed_ = addChoice(texts, "How many times as fast as it was recorded (+ and -)");
    speed_->Bind(wxEVT_CHOICE, [this](wxCommandEvent&) { onSpeed(speed()); });
    setSpeed(1);
    place_ = new wxStaticText(this, wxID_ANY, "");
    GetSizer()->Add(place_, 0, wxLEFT | wxALIGN_CENTER_VERTICAL, FromDIP(8));
}

void ControlBar::buildViewControls() {
    camera_ = addChoice({"Perspective", "Follow", "Top"}, "Camera (P, F, T)");
    camera_->Bind(wxEVT_CHOICE, [this](wxCommandEvent& event) {
        onAction(cameras.at(static_cast<size_t>(event.GetSelection())));
    });
    colours_ = addChoice({"Label", "Height", "Intensity", "Residual", "Reason"},
                         "What the colour of a point tells (1 to 5)");
    colours_->Bind(wxEVT_CHOICE, [this](wxCommandEvent& event) {
        onAction(colours.at(static_cast<size_t>(event.GetSelection())));
    });
    const int least = static_cast<int>(ViewState::minPointSize * pointSteps);
    const int most = static_cast<int>(ViewState::maxPointSize * pointSteps);
    pointSize_ = new wxSlider(this, wxID_ANY, least, least, most, wxDefaultPosition,
                              FromDIP(wxSize(110, -1)));
    pointSize_->SetToolTip("Size of the points ([ and ])");
    pointSize_->Bind(wxEVT_SLIDER,
                     [this](wxCommandEvent& event) { onPointSize(event.GetInt() / pointSteps); });
    GetSizer()->Add(pointSize_, 0, wxALL | wxALIGN_CENTER_VERTICAL, FromDIP(2));
    addButton(Action::SwitchTheme, tipOf(Action::SwitchTheme));
}

void ControlBar::setTheme(const Theme& theme) {
    theme_ = &theme;
    for (const Button& button : buttons_) {
        const Icon icon =
            button.control == playButton_ && playing_ ? Icon::Pause : iconOfAction(button.action);
        button.control->SetBitmap(iconOf(icon, theme.text));
        button.control->SetBitmapDisabled(
            iconOf(icon, theme.subtle.ChangeLightness(theme.dark ? 60 : 150)));
    }
}

void ControlBar::setPlaying(bool playing, bool canPause) {
    for (const Button& button : buttons_) {
        const bool ofPlay =
            button.action >= Action::PlayOrPause && button.action <= Action::FirstTurn;
        if (ofPlay && button.control->IsEnabled() != canPause) button.control->Enable(canPause);
    }
    if (speed_->IsEnabled() != canPause) speed_->Enable(canPause);
    if (playing == playing_) return;
    playing_ = playing;
    playButton_->SetBitmap(iconOf(playing ? Icon::Pause : Icon::Play, theme_->text));
}

void ControlBar::setPlace(std::optional<uint64_t> turn, uint64_t turns) {
    std::string text;
    if (turn) text = "turn " + rawlog::grouped(*turn + 1);
    if (turn && turns > 0) text += " / " + rawlog::grouped(turns);
    if (place_->GetLabel() == text) return;
    place_->SetLabel(text);
    place_->SetMinSize(place_->GetBestSize());
    Layout();
}

void ControlBar::setChoices(const SceneChoices& choices, CameraMode camera) {
    colours_->SetSelection(static_cast<int>(choices.colourBy));
    pointSize_->SetValue(static_cast<int>(std::lround(choices.pointSize * pointSteps)));
    camera_->SetSelection(camera == CameraMode::Top ? 2 : camera == CameraMode::Follow ? 1 : 0);
}

void ControlBar::setSpeed(double factor) {
    const auto place = std::ranges::lower_bound(speeds_, factor);
    const auto index = static_cast<unsigned>(place - speeds_.begin());
    if (place == speeds_.end() || *place != factor) {
        speeds_.insert(place, factor);
        speed_->Insert(speedText(factor), index);
    }
    speed_->SetSelection(static_cast<int>(index));
}

double ControlBar::speed() const { return speeds_.at(static_cast<size_t>(speed_->GetSelection())); }

void ControlBar::changeSpeed(int steps) {
    const int last = static_cast<int>(speeds_.size()) - 1;
    speed_->SetSelection(std::clamp(speed_->GetSelection() + steps, 0, last));
    onSpeed(speed());
}

}  // namespace offmap::window
