// SPDX-License-Identifier: BSD-3-Clause
#include "MainFrame.h"

#include "HelpDialogs.h"
#include "WindowIcon.h"
#include "WxText.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <wx/anybutton.h>
#include <wx/checkbox.h>
#include <wx/choice.h>
#include <wx/display.h>
#include <wx/dnd.h>
#include <wx/sizer.h>
#include <wx/slider.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

constexpr int pause = 100;  // [ms] between looks at figures and signals

/// A file that is dropped on the window.
class FileDrop : public wxFileDropTarget {
 public:
    explicit FileDrop(std::function<void(const std::string&)> open) : open_(std::move(open)) {}
    bool OnDropFiles(wxCoord, wxCoord, const wxArrayString& files) override {
        for (const wxString& file : files) open_(fromWx(file));
        return !files.empty();
    }

 private:
    std::function<void(const std::string&)> open_;
};

std::vector<wxRect> screens() {
    std::vector<wxRect> areas;
    for (unsigned i = 0; i < wxDisplay::GetCount(); ++i) {
        areas.push_back(wxDisplay(i).GetClientArea());
    }
    return areas;
}

/// Whether a key means something to what has the focus.
bool isFor(const wxWindow* focus, Action action) {
    const auto* text = dynamic_cast<const wxTextEntry*>(focus);
    if (text) return text->IsEditable();
    const bool pressed = wxDynamicCast(focus, wxAnyButton) || wxDynamicCast(focus, wxCheckBox) ||
                         wxDynamicCast(focus, wxChoice);
    const bool moved = wxDynamicCast(focus, wxSlider) || wxDynamicCast(focus, TimelinePane);
    const bool isArrow = action == Action::StepForward || action == Action::StepBack;
    return (pressed && action == Action::PlayOrPause) ||
           (moved && (isArrow || action == Action::FirstTurn));
}

}  // namespace

MainFrame::MainFrame(FileReader reader, SessionRequest request, wxConfigBase& settings)
    : wxFrame(nullptr, wxID_ANY, "offmap-view"),
      preferences_(settings),
      request_(std::move(request)),
      commandLine_(request_.live),
      menu_(new MainMenu),
      workspace_(new Workspace(this)),
      actions_(makeActions()),
      timer_(this),
      exports_(reader, exportEvents()),
      session_(std::move(reader), sessionEvents()) {
    SetIcons(windowIcon());
    SetMenuBar(menu_);
    SetMinSize(FromDIP(wxSize(640, 420)));
    SetDropTarget(new FileDrop([this](const std::string& file) { openFile(file); }));
    wireParts();
    wireMenu();
    restore();
    workspace_->parameters->setConfig(request_.config);
    timer_.Start(pause);
    workspace_->stage->canvas().SetFocus();
    if (!request_.live.from.source.empty() || !request_.live.shared.map.empty()) {
        open();
    } else {
        workspace_->messages->ShowMessage(
            "Open a log (Ctrl+O) and a map (Ctrl+M), or drop them here", wxICON_INFORMATION);
    }
}

MainFrame::~MainFrame() {
    exports_.close();
    session_.close();
}

void MainFrame::wireParts() {
    workspace_->controls->onAction = [this](Action action) { perform(action); };
    workspace_->controls->onPointSize = [this](double pixels) { setPointSize(pixels); };
    workspace_->controls->onSpeed = [this](double factor) {
        withPlayback([&](Playback& playback) { playback.setSpeed(factor); });
    };
    workspace_->stage->onShown = [this](const Composed& composed) { showScan(composed); };
    workspace_->stage->onPicked = [this](const view::SegmentStory* story) { showStory(story); };
    workspace_->plan->onLookAt = [this](const auto& place) { workspace_->stage->lookAt(place); };
    workspace_->timeline->onJump = [this](uint64_t turn) {
        withPlayback([&](Playback& playback) { playback.jumpTo(turn); });
    };
    workspace_->parameters->onError = [this](const std::string& error) { showFailure(error); };
    workspace_->parameters->onChange = [this](const rawlog::Config& config) {
        request_.config = config;
        withPlayback([&](Playback& playback) { playback.setConfig(config); });
    };
}

void MainFrame::wireMenu() {
    Bind(wxEVT_MENU, [this](wxCommandEvent& event) {
        if (const auto action = MainMenu::actionOf(event.GetId())) return perform(*action);
        if (const auto log = menu_->recentLog(event.GetId())) return openLog(*log);
        if (const auto map = menu_->recentMap(event.GetId())) return openMap(*map);
        if (event.GetId() == wxID_ABOUT) return showAbout(this);
        event.Skip();
    });
    Bind(wxEVT_CHAR_HOOK, [this](wxKeyEvent& event) { onKey(event); });
    Bind(wxEVT_TIMER, [this](wxTimerEvent&) { onTimer(); });
    Bind(wxEVT_CLOSE_WINDOW, [this](wxCloseEvent&) { onClose(); });
    menu_->setRecent(preferences_.recentLogs(), preferences_.recentMaps());
}

void MainFrame::onKey(wxKeyEvent& event) {
    const auto action = actionOf(event);
    if (!action || (!event.ControlDown() && isFor(FindFocus(), *action))) return event.Skip();
    perform(*action);
}

void MainFrame::showScan(const Composed& composed) {
    const uint64_t turn = composed.frame->arrived.number;
    workspace_->plan->show(composed.frame);
    workspace_->timeline->setPosition(turn);
    workspace_->controls->setPlace(turn, turns_);
}

void MainFrame::showStory(const view::SegmentStory* story) {
    const auto playback = session_.playback();
    if (!story || !playback) return workspace_->verdict->clear();
    auto lines = view::linesOf(*story, workspace_->stage->map());
    const std::string sentence = lines.empty() ? "" : lines.back().second;
    if (!lines.empty()) lines.pop_back();
    workspace_->verdict->show(lines, sentence);
}

void MainFrame::dismissOldMessage() {
    constexpr std::chrono::seconds readable{6};
    if (!toldAt_ || std::chrono::steady_clock::now() - *toldAt_ < readable) return;
    toldAt_.reset();
    workspace_->messages->Dismiss();
}

void MainFrame::onTimer() {
    // One dialog after the other, then the window.
    if (interruption_.came()) return static_cast<void>(dialogs_.cancelOne() || Close(true));
    dismissOldMessage();
    for (const ReducedTurn& turn : reducedTurns_.take()) {
        workspace_->timeline->add(turn.number, turn.removedShare, turn.milliseconds, turn.suspect);
    }
    const auto playback = session_.playback();
    workspace_->controls->setPlaying(playback && playback->playing(),
                                     playback && playback->canPause());
    if (playback) tellOfFailures(*playback);
    const auto frame = playback ? playback->latest() : nullptr;
    if (!frame) return;
    workspace_->figures->show(playback->figures(), frame);
    const auto& record = frame->reduced.record;
    const double points = double(record.counts.returns), removed = double(record.removed());
    const std::chrono::duration<double> now = std::chrono::steady_clock::now() - began_;
    workspace_->plots->add(now.count(), points > 0 ? removed / points : 0, record.milliseconds,
                           frame->latency, points - removed);
}

void MainFrame::restore() {
    const auto areas = screens();
    state_ = preferences_.load(areas);
    SetSize(state_.window ? *state_.window : wxRect(wxDefaultPosition, FromDIP(wxSize(1400, 880))));
    if (state_.maximised) Maximize();
    Layout();
    workspace_->setSashes(state_.sashes);
    const bool isGiven = request_.live.from.speed != app::SourceOptions().speed;
    workspace_->controls->setSpeed(isGiven ? request_.live.from.speedFactor() : state_.speed);
    setDark(state_.dark);
    setCameraMode(state_.cameraMode);
    change([&](SceneChoices& choices) {
        choices = {state_.colourBy, state_.pointSize, state_.shown};
    });
}

void MainFrame::save() {
    if (!IsMaximized() && !IsFullScreen()) state_.window = GetRect();
    state_.maximised = IsMaximized();
    state_.sashes = workspace_->sashes();
    state_.camera = workspace_->stage->camera();
    state_.cameraMode = workspace_->stage->cameraMode();
    const SceneChoices& choices = workspace_->stage->choices();
    state_.pointSize = choices.pointSize;
    state_.colourBy = choices.colourBy;
    state_.shown = choices.shown;
    state_.speed = workspace_->controls->speed();
    preferences_.save(state_);
}

void MainFrame::onClose() {
    timer_.Stop();
    save();
    if (const auto playback = session_.playback(); playback && playback->recording()) {
        finishRecording(*playback);
    }
    exports_.close();
    session_.close();
    Destroy();
}

}  // namespace offmap::window
