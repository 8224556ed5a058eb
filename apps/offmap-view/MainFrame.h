// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Exports.h"
#include "LiveDialog.h"
#include "MainMenu.h"
#include "OpenDialogs.h"
#include "Preferences.h"
#include "ReducedTurns.h"
#include "Session.h"
#include "Workspace.h"
#include "input/Interruption.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <wx/config.h>
#include <wx/frame.h>
#include <wx/timer.h>

namespace offmap::window {

/// The window: what its parts tell each other.
class MainFrame : public wxFrame {
 public:
    /// \param request is opened at once; may be empty \param settings are read and kept up
    MainFrame(FileReader reader, SessionRequest request, wxConfigBase& settings);
    ~MainFrame() override;

    Workspace& workspace() { return *workspace_; }
    Session& session() { return session_; }
    void perform(Action action);

 private:
    // MainFrame.cpp
    void wireParts();
    void wireMenu();
    void restore();
    void save();
    void showScan(const Composed& composed);
    void showStory(const view::SegmentStory* story);
    void onTimer();
    void dismissOldMessage();
    void onClose();
    void onKey(wxKeyEvent& event);

    // MainFrameFiles.cpp
    Session::Events sessionEvents();
    Exports::Events exportEvents();
    void openFile(const std::string& file);
    void openLog(const std::string& file);
    void openMap(const std::string& file);
    void open();
    void showOpened(const Opened& opened);
    void showNothing(const Failure& failure);
    void showFailure(const std::string& message);
    void tellOfFailures(Playback& playback);
    void rememberFiles();
    void toggleRecording();
    void finishRecording(Playback& playback);

    // MainFrameActions.cpp
    std::map<Action, std::function<void()>> makeActions();
    void askForLog();
    void askForMap();
    void askForLiveSource();
    void setDark(bool dark);
    void change(const std::function<void(SceneChoices&)>& choose);
    void setCameraMode(CameraMode mode);
    void setPointSize(double pixels);
    void withPlayback(const std::function<void(Playback&)>& act);
    void saveScreenshot();
    std::string askForTarget(const char* title, const char* name, const char* files);
    void exportFigure();
    void exportTurns();
    void tell(const std::string& message);
    const Theme& theme() const;

    Preferences preferences_;
    SessionRequest request_;
    const app::LiveRequest commandLine_;
    ViewState state_;
    LiveEntries liveEntries_;
    bool failureIsTold_ = false;                                   // of what is open
    std::optional<std::chrono::steady_clock::time_point> toldAt_;  // what need not be read for long
    uint64_t turns_ = 0;                                           // of the log; 0: not known
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    app::Interruption interruption_;
    OpenDialogs dialogs_;
    MainMenu* menu_;
    Workspace* workspace_;
    std::map<Action, std::function<void()>> actions_;
    wxTimer timer_;
    ReducedTurns reducedTurns_;
    Exports exports_;
    Session session_;  // last: its threads end before the rest does
};

}  // namespace offmap::window
