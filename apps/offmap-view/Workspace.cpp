// SPDX-License-Identifier: BSD-3-Clause
#include "Workspace.h"

#include <wx/notebook.h>
#include <wx/sizer.h>
#include <wx/splitter.h>

namespace offmap::window {

namespace {

/// [px] of the second half if negative, as splitters have it.
const std::map<std::string, int> usualSashes{{"side", -400}, {"plan", 200}, {"verdict", 215}};

}  // namespace

Workspace::Workspace(wxWindow* parent)
    : wxPanel(parent), controls(new ControlBar(this)), messages(new wxInfoBar(this)) {
    wxSplitterWindow* wide = addSplitter(this, "side", 1.0);
    stage = new ScanStage(wide);
    wide->SplitVertically(stage, makeSide(wide));
    timeline = new TimelinePane(this);
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(controls, 0, wxEXPAND | wxALL, FromDIP(4));
    sizer->Add(messages, 0, wxEXPAND);
    sizer->Add(wide, 1, wxEXPAND);
    sizer->Add(timeline, 0, wxEXPAND);
    SetSizer(sizer);
}

/// \param gravity share of what a greater window adds that goes to the first half
wxSplitterWindow* Workspace::addSplitter(wxWindow* parent, const std::string& name,
                                         double gravity) {
    auto* splitter = new wxSplitterWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                                          wxSP_LIVE_UPDATE | wxSP_NOBORDER);
    splitter->SetMinimumPaneSize(FromDIP(80));
    splitter->SetSashGravity(gravity);
    splitters_[name] = splitter;
    return splitter;
}

wxWindow* Workspace::makeSide(wxWindow* parent) {
    wxSplitterWindow* side = addSplitter(parent, "plan", 0.4);
    plan = new PlanPane(side);
    wxSplitterWindow* lower = addSplitter(side, "verdict", 0.0);
    verdict = new VerdictPane(lower);
    lower->SplitHorizontally(verdict, makeNotebook(lower));
    side->SplitHorizontally(plan, lower);
    return side;
}

wxWindow* Workspace::makeNotebook(wxWindow* parent) {
    auto* notebook = new wxNotebook(parent, wxID_ANY);
    figures = new FiguresPane(notebook);
    plots = new PlotsPane(notebook);
    parameters = new ParameterPanel(notebook);
    notebook->AddPage(figures, "Figures");
    notebook->AddPage(plots, "Plots");
    notebook->AddPage(parameters, "Parameters");
    return notebook;
}

// NOLINTNEXTLINE(readability-make-member-function-const): what is shown changes
void Workspace::setTheme(const Theme& theme) {
    controls->setTheme(theme);
    stage->setTheme(theme);
    plan->setTheme(theme);
    verdict->setTheme(theme);
    figures->setTheme(theme);
    plots->setTheme(theme);
    timeline->setTheme(theme);
}

// NOLINTNEXTLINE(readability-make-member-function-const): what is shown changes
void Workspace::clear() {
    const auto nothing = std::make_shared<core::LineMap>(std::vector<core::Wall>());
    stage->setMap(nothing);
    plan->setMap(nothing);
    plan->show(nullptr);
    plan->clearTrajectory();
    timeline->setTurns(0);
    plots->clear();
    figures->clear();
    verdict->clear();
    controls->setPlace({}, 0);
}

std::map<std::string, int> Workspace::sashes() const {
    std::map<std::string, int> positions;
    for (const auto& [name, splitter] : splitters_) positions[name] = splitter->GetSashPosition();
    return positions;
}

void Workspace::setSashes(const std::map<std::string, int>& sashes) {
    // From the outside in: each moves those within.
    for (const char* name : {"side", "plan", "verdict"}) {
        const auto saved = sashes.find(name);
        splitters_.at(name)->SetSashPosition(saved == sashes.end() ? FromDIP(usualSashes.at(name))
                                                                   : saved->second);
        Layout();
    }
}

}  // namespace offmap::window
