// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../support/Places.h"
#include "MainFrame.h"
#include "Pump.h"
#include "WxText.h"

#include <gtk/gtk.h>
#include <memory>
#include <string>
#include <vector>
#include <wx/bmpbuttn.h>
#include <wx/dnd.h>
#include <wx/fileconf.h>
#include <wx/textctrl.h>
#include <wx/weakref.h>

namespace offmap::test {

/// The window of the program, and somebody who looks at it.
class OpenedFrame {
 public:
    OpenedFrame(const std::filesystem::path& settings, const window::SessionRequest& request)
        : settings_("", "", window::toWx(settings.string()), "", wxCONFIG_USE_LOCAL_FILE),
          frame_(
              new window::MainFrame(window::FileReader({}, offmapBinary()), request, settings_)) {
        frame_->Show();
        wxYield();
    }
    ~OpenedFrame() {
        if (isOpen()) timeToClose();
    }
    OpenedFrame(const OpenedFrame&) = delete;
    OpenedFrame& operator=(const OpenedFrame&) = delete;

    bool isOpen() const { return frame_.get() != nullptr; }
    window::MainFrame& frame() { return *frame_; }
    window::ScanStage& stage() { return *frame_->workspace().stage; }
    std::string title() { return window::fromWx(frame_->GetTitle()); }
    window::Preferences preferences() { return window::Preferences(settings_); }

    /// Until nothing of it is left.
    std::chrono::steady_clock::duration timeToClose() {
        return timeOf([this] {
            frame_->Close(true);
            pumpUntil([this] { return !isOpen(); });
        });
    }

    /// The number of the turn in the picture.
    uint64_t turn() { return stage().shown()->frame->arrived.number; }
    bool showsAny() {
        return pumpUntil([this] { return stage().shown() != nullptr; });
    }
    bool showsTurn(uint64_t number) {
        return pumpUntil([&] { return stage().shown() && turn() == number; });
    }

    /// What is told above the picture; empty: nothing.
    std::string message() {
        const wxInfoBar& bar = *frame_->workspace().messages;
        return bar.IsShown() ? textOf(bar.GetHandle()) : std::string();
    }
    bool says(const std::string& part) {
        return pumpUntil([&] { return message().find(part) != std::string::npos; });
    }

    void drop(const std::vector<std::filesystem::path>& files) {
        wxArrayString names;
        for (const auto& file : files) names.Add(window::toWx(file.string()));
        dynamic_cast<wxFileDropTarget&>(*frame_->GetDropTarget()).OnDropFiles(10, 10, names);
    }
    void menu(int id) {
        wxCommandEvent event(wxEVT_MENU, id);
        frame_->ProcessWindowEvent(event);
    }
    /// Asks the window before whatever has the focus, as the toolkit does.
    /// \return whether the window took it
    bool key(int code) {
        wxKeyEvent event(wxEVT_CHAR_HOOK);
        event.m_keyCode = code;
        return frame_->ProcessWindowEvent(event);
    }
    void focusField() { firstOf<wxTextCtrl>(*frame_->workspace().parameters)->SetFocus(); }
    void focusButton() { firstOf<wxBitmapButton>(*frame_->workspace().controls)->SetFocus(); }

 private:
    static std::string textOf(GtkWidget* widget) {
        if (GTK_IS_LABEL(widget)) return gtk_label_get_text(GTK_LABEL(widget));
        std::string text;
        if (!GTK_IS_CONTAINER(widget)) return text;
        gtk_container_forall(
            GTK_CONTAINER(widget),
            [](GtkWidget* child, void* all) { *static_cast<std::string*>(all) += textOf(child); },
            &text);
        return text;
    }
    template <class Control>
    static Control* firstOf(const wxWindow& window) {
        for (wxWindow* child : window.GetChildren()) {
            if (auto* control = dynamic_cast<Control*>(child)) return control;
            if (auto* control = firstOf<Control>(*child)) return control;
        }
        return nullptr;
    }

    wxFileConfig settings_;
    wxWeakRef<window::MainFrame> frame_;
};

}  // namespace offmap::test
