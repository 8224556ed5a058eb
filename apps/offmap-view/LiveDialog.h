// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LiveEntries.h"
#include "Theme.h"

#include <optional>
#include <string>
#include <vector>
#include <wx/dialog.h>

class wxChoice;
class wxFlexGridSizer;
class wxStaticText;
class wxTextCtrl;

namespace offmap::window {

/// Asks for a live source and where the robot is.
class LiveDialog : public wxDialog {
 public:
    LiveDialog(wxWindow* parent, const LiveEntries& entries, const Theme& theme);

    /// As they stand in the fields: what to begin with the next time.
    LiveEntries entries() const;
    /// Of a dialog that was closed with OK.
    const LiveChoice& choice() const { return *choice_; }

 private:
    /// A field with its name in front; both are there or not.
    struct Row {
        wxWindow* name;
        wxWindow* field;
    };

    Row addRow(const char* name, wxWindow* field);
    wxWindow* makeFileField(const std::string& file);
    wxWindow* makePoseFields(const LiveEntries& entries);
    void show(const LiveEntries& entries);
    void arrange();
    void browse();
    void accept();

    wxFlexGridSizer* grid_;
    wxChoice *kind_, *poses_;
    wxTextCtrl *port_, *file_ = nullptr, *label_;
    wxTextCtrl *x_ = nullptr, *y_ = nullptr, *yaw_ = nullptr;
    Row portRow_{}, fileRow_{}, labelRow_{}, poseRow_{};
    wxStaticText* error_;
    std::optional<LiveChoice> choice_;
};

}  // namespace offmap::window
