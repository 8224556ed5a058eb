// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>
#include <wx/dialog.h>
#include <wx/modalhook.h>

namespace offmap::window {

/// The dialogs that the user has not answered yet; the toolkit's list of windows lacks some.
class OpenDialogs : public wxModalDialogHook {
 public:
    OpenDialogs() { Register(); }

    /// Cancels the uppermost. \return whether there was one
    bool cancelOne();

 protected:
    int Enter(wxDialog* dialog) override;
    void Exit(wxDialog* dialog) override;

 private:
    std::vector<wxDialog*> dialogs_;  // from below
};

}  // namespace offmap::window
