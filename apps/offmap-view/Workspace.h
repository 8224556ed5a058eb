// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ControlBar.h"
#include "FiguresPane.h"
#include "ParameterPanel.h"
#include "PlanPane.h"
#include "PlotsPane.h"
#include "ScanStage.h"
#include "TimelinePane.h"
#include "VerdictPane.h"

#include <map>
#include <string>
#include <wx/infobar.h>
#include <wx/panel.h>

class wxNotebook;
class wxSplitterWindow;

namespace offmap::window {

/// Where everything stands in the window. Knows nothing of what it is for.
class Workspace : public wxPanel {
 public:
    explicit Workspace(wxWindow* parent);

    ControlBar* controls;
    wxInfoBar* messages;
    ScanStage* stage;
    PlanPane* plan;
    VerdictPane* verdict;
    FiguresPane* figures;
    PlotsPane* plots;
    ParameterPanel* parameters;
    TimelinePane* timeline;

    void setTheme(const Theme& theme);
    /// Nothing is open.
    void clear();
    std::map<std::string, int> sashes() const;  ///< [px] by name
    /// Those that are not named stand where they usually do.
    void setSashes(const std::map<std::string, int>& sashes);

 private:
    wxSplitterWindow* addSplitter(wxWindow* parent, const std::string& name, double gravity);
    wxWindow* makeSide(wxWindow* parent);
    wxWindow* makeNotebook(wxWindow* parent);

    std::map<std::string, wxSplitterWindow*> splitters_;
};

}  // namespace offmap::window
