// SPDX-License-Identifier: BSD-3-Clause
// What the window opens and records.
#include "MainFrame.h"
#include "WxText.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <system_error>

namespace offmap::window {

namespace {

bool isThere(const std::filesystem::path& file) {
    std::error_code unknown;
    return std::filesystem::exists(file, unknown);
}

std::string absolutePath(const std::filesystem::path& file) {
    return std::filesystem::absolute(file).string();
}

std::string speedText(double factor) {
    return std::isinf(factor) ? "max" : fmt::format("{}", factor);
}

}  // namespace

Session::Events MainFrame::sessionEvents() {
    Session::Events events;
    events.onOpened = [this](const Opened& opened) {
        CallAfter([this, opened] { showOpened(opened); });
    };
    events.onFailure = [this](const Failure& failure) {
        CallAfter([this, failure] { showNothing(failure); });
    };
    events.onClosed = [this] { reducedTurns_.take(); };
    events.playback.onFrame = [this](const live::LiveFramePtr& frame) {
        reducedTurns_.add(*frame);
    };
    events.playback.onLatest = [this](const live::LiveFramePtr& frame) {
        workspace_->stage->take(frame);
    };
    return events;
}

Exports::Events MainFrame::exportEvents() {
    Exports::Events events;
    events.onDone = [this](const std::string& message) {
        CallAfter([this, message] { tell(message); });
    };
    events.onFailure = [this](const std::string& message) {
        CallAfter([this, message] { showFailure(message); });
    };
    return events;
}

/// By its name: a log, or else a map.
void MainFrame::openFile(const std::string& file) {
    const std::string extension = std::filesystem::path(file).extension().string();
    const bool isLog = extension == ".rawlog" || extension == ".pcap" || extension == ".pcapng" ||
                       extension == ".ini";
    isLog ? openLog(file) : openMap(file);
}

void MainFrame::openLog(const std::string& file) {
    state_.folder = std::filesystem::path(file).parent_path().string();
    // Not what was chosen for a live source since.
    request_.live.from = commandLine_.from;
    request_.live.shared.poses = commandLine_.shared.poses;
    request_.live.from.source = file;
    request_.startAt = 0;
    request_.play = false;
    open();
}

void MainFrame::openMap(const std::string& file) {
    state_.folder = std::filesystem::path(file).parent_path().string();
    request_.live.shared.map = file;
    if (!session_.opening()) {  // else with what is being opened, from where that begins
        const auto playback = session_.playback();
        const auto frame = playback ? playback->latest() : nullptr;
        request_.startAt = frame ? frame->arrived.number : 0;
        request_.play = playback && playback->playing();
    }
    open();
}

void MainFrame::open() {
    workspace_->messages->Dismiss();
    const auto playback = session_.playback();
    if (playback && playback->recording()) finishRecording(*playback);
    request_.live.from.speed = speedText(workspace_->controls->speed());
    SetTitle("offmap-view: opening ...");
    session_.open(request_);
}

void MainFrame::showOpened(const Opened& opened) {
    if (session_.opening()) return;  // the next one
    turns_ = opened.turns;
    failureIsTold_ = false;
    workspace_->clear();
    workspace_->stage->setMap(opened.map);
    workspace_->plan->setMap(opened.map);
    workspace_->timeline->setTurns(turns_);
    rememberFiles();
    const std::string& source = request_.live.from.source;
    const std::filesystem::path& map = request_.live.shared.map;
    SetTitle(toWx(fmt::format(
        "{} - offmap-view", source.empty() ? map.filename().string() : opened.sourceDescription)));
    if (!opened.warnings.empty()) {
        workspace_->messages->ShowMessage(toWx(fmt::format("{}", fmt::join(opened.warnings, "; "))),
                                          wxICON_WARNING);
    }
    withPlayback([&](Playback& playback) {
        if (const auto frame = playback.latest()) workspace_->stage->take(frame);
    });
}

void MainFrame::showFailure(const std::string& message) {
    toldAt_.reset();
    workspace_->messages->ShowMessage(toWx(message), wxICON_ERROR);
}

/// What cannot be opened does not stand in the way of what is opened next.
void MainFrame::showNothing(const Failure& failure) {
    if (session_.opening()) return;  // the next one
    std::filesystem::path& map = request_.live.shared.map;
    std::string& log = request_.live.from.source;
    if (failure.isOfMap) {
        if (!isThere(map)) preferences_.forgetRecentMap(absolutePath(map));
        map.clear();
    } else {
        if (!isThere(log)) preferences_.forgetRecentLog(absolutePath(log));
        log.clear();
    }
    menu_->setRecent(preferences_.recentLogs(), preferences_.recentMaps());
    workspace_->clear();
    turns_ = 0;
    SetTitle("offmap-view");
    showFailure(failure.message);
}

/// A port of the network is no file.
void MainFrame::rememberFiles() {
    const std::filesystem::path log = request_.live.from.source, map = request_.live.shared.map;
    if (isThere(log)) preferences_.addRecentLog(absolutePath(log));
    if (isThere(map)) preferences_.addRecentMap(absolutePath(map));
    menu_->setRecent(preferences_.recentLogs(), preferences_.recentMaps());
}

/// Each once.
void MainFrame::tellOfFailures(Playback& playback) {
    if (playback.recordingFailed()) finishRecording(playback);
    if (failureIsTold_) return;
    std::string why = playback.failure();
    const live::SourceHealth health = playback.health();
    if (why.empty() && health.state == live::SourceState::Failed) why = health.message;
    if (why.empty()) return;
    failureIsTold_ = true;
    showFailure(why);
}

void MainFrame::toggleRecording() {
    const auto playback = session_.playback();
    if (!playback) return showFailure("there is nothing to record yet; open a log (Ctrl+O)");
    if (playback->recording()) return finishRecording(*playback);
    const std::string file =
        askForTarget("Record the reduced log", "recorded.rawlog", "Logs (*.rawlog)|*.rawlog");
    if (file.empty()) return;
    withPlayback([&](Playback& p) { p.record(file); });
    if (playback->recording()) tell("recording to " + file + "; Ctrl+R ends it");
}

void MainFrame::finishRecording(Playback& playback) {
    try {
        tell("wrote " + playback.finishRecording().string());
    } catch (const std::exception& error) {
        showFailure(error.what());
    }
}

}  // namespace offmap::window
