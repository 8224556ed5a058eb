// SPDX-License-Identifier: BSD-3-Clause
#include "HelpDialogs.h"
#include "MainFrame.h"
#include "PictureFile.h"
#include "RangeDialog.h"
#include "WxText.h"

#include <algorithm>
#include <wx/datetime.h>
#include <wx/filedlg.h>

namespace offmap::window {

namespace {

constexpr const char* logFiles =
    "Logs (*.rawlog;*.pcap;*.pcapng)|*.rawlog;*.pcap;*.pcapng|All files|*";
constexpr const char* allFiles = "All files|*";

}  // namespace

void MainFrame::perform(Action action) {
    const auto found = actions_.find(action);
    if (found != actions_.end()) found->second();
}

std::map<Action, std::function<void()>> MainFrame::makeActions() {
    const auto colourBy = [this](view::ColourBy by) {
        return [this, by] { change([by](SceneChoices& choices) { choices.colourBy = by; }); };
    };
    const auto toggle = [this](bool Shown::*part) {
        return [this, part] {
            change([part](SceneChoices& choices) { choices.shown.*part = !(choices.shown.*part); });
        };
    };
    const auto play = [this](auto act) { return [this, act] { withPlayback(act); }; };
    return {
        {Action::OpenLog, [this] { askForLog(); }},
        {Action::OpenMap, [this] { askForMap(); }},
        {Action::OpenLive, [this] { askForLiveSource(); }},
        {Action::SaveScreenshot, [this] { saveScreenshot(); }},
        {Action::ExportFigure, [this] { exportFigure(); }},
        {Action::ExportTurns, [this] { exportTurns(); }},
        {Action::Record, [this] { toggleRecording(); }},
        {Action::Quit, [this] { Close(); }},
        {Action::PlayOrPause, play([](Playback& p) { p.playing() ? p.pause() : p.play(); })},
        {Action::StepForward, play([](Playback& p) { p.step(1); })},
        {Action::StepBack, play([](Playback& p) { p.step(-1); })},
        {Action::Faster, [this] { workspace_->controls->changeSpeed(1); }},
        {Action::Slower, [this] { workspace_->controls->changeSpeed(-1); }},
        {Action::FirstTurn, play([](Playback& p) { p.jumpTo(0); })},
        {Action::TopCamera, [this] { setCameraMode(CameraMode::Top); }},
        {Action::FollowCamera, [this] { setCameraMode(CameraMode::Follow); }},
        {Action::PerspectiveCamera, [this] { setCameraMode(CameraMode::Perspective); }},
        {Action::ResetView, [this] { workspace_->stage->resetView(); }},
        {Action::ColourByLabel, colourBy(view::ColourBy::Label)},
        {Action::ColourByHeight, colourBy(view::ColourBy::Height)},
        {Action::ColourByIntensity, colourBy(view::ColourBy::Intensity)},
        {Action::ColourByResidual, colourBy(view::ColourBy::Residual)},
        {Action::ColourByReason, colourBy(view::ColourBy::Reason)},
        {Action::ShowMapped, toggle(&Shown::mapped)},
        {Action::ShowWalls, toggle(&Shown::walls)},
        {Action::ShowEllipse, toggle(&Shown::ellipse)},
        {Action::SmallerPoints,
         [this] { setPointSize(workspace_->stage->choices().pointSize - 0.5); }},
        {Action::LargerPoints,
         [this] { setPointSize(workspace_->stage->choices().pointSize + 0.5); }},
        {Action::SwitchTheme, [this] { setDark(!state_.dark); }},
        {Action::FullScreen, [this] { ShowFullScreen(!IsFullScreen()); }},
        {Action::ShowShortcuts, [this] { ShortcutsDialog(this).ShowModal(); }},
        {Action::ClearSelection, [this] { workspace_->stage->clearSelection(); }},
    };
}

void MainFrame::withPlayback(const std::function<void(Playback&)>& act) {
    try {
        if (const auto playback = session_.playback()) act(*playback);
    } catch (const std::exception& error) {
        showFailure(error.what());
    }
}

void MainFrame::askForLog() {
    wxFileDialog dialog(this, "Open a log", toWx(state_.folder), "", logFiles,
                        wxFD_OPEN | wxFD_FILE_MUST_EXIST);
    if (dialog.ShowModal() == wxID_OK) openLog(fromWx(dialog.GetPath()));
}

void MainFrame::askForMap() {
    wxFileDialog dialog(this, "Open a map", toWx(state_.folder), "", allFiles,
                        wxFD_OPEN | wxFD_FILE_MUST_EXIST);
    if (dialog.ShowModal() == wxID_OK) openMap(fromWx(dialog.GetPath()));
}

void MainFrame::askForLiveSource() {
    LiveDialog dialog(this, liveEntries_, theme());
    const bool accepted = dialog.ShowModal() == wxID_OK;
    liveEntries_ = dialog.entries();
    if (!accepted) return;
    request_.live.from = dialog.choice().from;
    request_.live.shared.poses = dialog.choice().poses;
    request_.startAt = 0;
    open();
}

void MainFrame::setDark(bool dark) {
    state_.dark = dark;
    applyToToolkit(theme());
    workspace_->setTheme(theme());
}

void MainFrame::change(const std::function<void(SceneChoices&)>& choose) {
    SceneChoices choices = workspace_->stage->choices();
    choose(choices);
    workspace_->stage->setChoices(choices);
    workspace_->controls->setChoices(choices, workspace_->stage->cameraMode());
}

void MainFrame::setPointSize(double pixels) {
    change([pixels](SceneChoices& choices) {
        choices.pointSize = std::clamp(pixels, ViewState::minPointSize, ViewState::maxPointSize);
    });
}

void MainFrame::setCameraMode(CameraMode mode) {
    workspace_->stage->setCameraMode(mode);
    workspace_->controls->setChoices(workspace_->stage->choices(), mode);
}

void MainFrame::saveScreenshot() {
    const std::string name = fromWx(wxDateTime::Now().Format("offmap-view-%Y%m%d-%H%M%S.png"));
    try {
        const std::filesystem::path file = std::filesystem::current_path() / name;
        writePicture(workspace_->stage->canvas().picture(), file);
        tell("wrote " + file.string());
    } catch (const std::exception& error) {
        showFailure(error.what());
    }
}

std::string MainFrame::askForTarget(const char* title, const char* name, const char* files) {
    wxFileDialog dialog(this, title, toWx(state_.folder), name, files,
                        wxFD_SAVE | wxFD_OVERWRITE_PROMPT);
    return dialog.ShowModal() == wxID_OK ? fromWx(dialog.GetPath()) : std::string();
}

void MainFrame::exportFigure() {
    const auto playback = session_.playback();
    const auto frame = playback ? playback->latest() : nullptr;
    if (!frame) return showFailure("there is no scan to export yet; open a log (Ctrl+O)");
    const std::string file =
        askForTarget("Export a figure", "figure.png", "Pictures (*.png)|*.png");
    if (file.empty()) return;
    const ScanStage& stage = *workspace_->stage;
    exports_.writeFigure(frame, stage.sharedMap(), stage.choices(), theme(), file);
}

void MainFrame::exportTurns() {
    const auto playback = session_.playback();
    if (!playback || !playback->canPause()) {
        return showFailure("only turns of a log can be exported; record what is live (Ctrl+R)");
    }
    RangeDialog dialog(this, turns_);
    if (dialog.ShowModal() != wxID_OK) return;
    const std::string file =
        askForTarget("Export reduced turns", "reduced.rawlog", "Logs (*.rawlog)|*.rawlog");
    if (file.empty()) return;
    tell("exporting to " + file + " ...");
    exports_.writeTurns(request_, workspace_->stage->sharedMap(), dialog.range(), file);
}

void MainFrame::tell(const std::string& message) {
    toldAt_ = std::chrono::steady_clock::now();
    workspace_->messages->ShowMessage(toWx(message), wxICON_INFORMATION);
}

const Theme& MainFrame::theme() const { return state_.dark ? Theme::darkOne() : Theme::lightOne(); }

}  // namespace offmap::window
