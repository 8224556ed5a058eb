// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <wx/dialog.h>

namespace offmap::window {

/// All keys, group by group.
class ShortcutsDialog : public wxDialog {
 public:
    explicit ShortcutsDialog(wxWindow* parent);
};

void showAbout(wxWindow* parent);

}  // namespace offmap::window
