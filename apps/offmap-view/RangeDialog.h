// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Exports.h"

#include <wx/dialog.h>

class wxSpinCtrl;

namespace offmap::window {

/// Asks which turns of a log are meant; to the user they count from 1.
class RangeDialog : public wxDialog {
 public:
    /// \param turns of the log; 0: not known
    RangeDialog(wxWindow* parent, uint64_t turns);

    TurnRange range() const;

 private:
    wxSpinCtrl* addField(wxSizer& grid, const char* name, int value, int most);

    wxSpinCtrl *first_, *last_;
};

}  // namespace offmap::window
