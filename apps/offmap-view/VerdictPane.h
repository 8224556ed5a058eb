// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Theme.h"

#include <string>
#include <utility>
#include <vector>
#include <wx/panel.h>

class wxTextCtrl;

namespace offmap::window {

/// Why a point was kept or removed: a sentence, and below it names and values. All of it can be
/// selected and copied.
class VerdictPane : public wxPanel {
 public:
    using Lines = std::vector<std::pair<std::string, std::string>>;

    explicit VerdictPane(wxWindow* parent);

    void show(const Lines& lines, const std::string& sentence);
    /// Shows how to get a verdict.
    void clear();
    void setTheme(const Theme& theme);

 private:
    void write();
    void writeLines();

    const Theme* theme_ = &Theme::darkOne();
    Lines lines_;
    std::string sentence_;
    wxTextCtrl* text_;
};

}  // namespace offmap::window
