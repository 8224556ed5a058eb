// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterPanel.h"

#include "ParameterFacts.h"
#include "ParameterSection.h"
#include "Preset.h"
#include "WxText.h"

#include <offmap/rawlog/ParameterTable.h>

#include <algorithm>
#include <array>
#include <wx/button.h>
#include <wx/filedlg.h>
#include <wx/filename.h>
#include <wx/scrolwin.h>
#include <wx/settings.h>
#include <wx/sizer.h>
#include <wx/srchctrl.h>

namespace offmap::window {

namespace {

/// What one tunes least comes folded.
bool opensAtFirst(std::string_view section) {
    constexpr std::array<std::string_view, 5> folded{"sensor", "pose", "odometry", "map", "orphan"};
    return std::ranges::find(folded, section) == folded.end();
}

wxString presetFiles() { return toWx("Presets (*.yaml)|*.yaml;*.yml|All files|*"); }

}  // namespace

ParameterPanel::ParameterPanel(wxWindow* parent)
    : wxPanel(parent),
      filter_(new wxSearchCtrl(this, wxID_ANY)),
      list_(new wxScrolledWindow(this, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL)) {
    filter_->SetDescriptiveText("Find a parameter");
    filter_->ShowCancelButton(true);
    filter_->Bind(wxEVT_TEXT, [this](wxCommandEvent&) {
        for (auto* section : sections_) section->filter(fromWx(filter_->GetValue()));
        arrange();
    });
    list_->SetScrollRate(0, FromDIP(12));
    addSections();
    alignColumns();

    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(filter_, wxSizerFlags().Expand().Border(wxALL, FromDIP(4)));
    sizer->Add(list_, wxSizerFlags(1).Expand());
    sizer->Add(makeButtons(), wxSizerFlags().Expand().Border(wxALL, FromDIP(4)));
    SetSizer(sizer);
    setConfig({});
}

void ParameterPanel::addSections() {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    const auto all = rawlog::parameters();
    for (auto begin = all.begin(); begin != all.end();) {
        const std::string_view name = sectionOf(*begin);
        const auto end =
            std::find_if(begin, all.end(), [&](const auto& p) { return sectionOf(p) != name; });
        auto* section = new ParameterSection(list_, {begin, end}, opensAtFirst(name));
        section->onEnter = [this](const auto& p, const std::string& text) { enter(p, text); };
        section->onFold = [this] { arrange(); };
        sizer->Add(section, wxSizerFlags().Expand().Border(wxRIGHT, FromDIP(8)));
        sections_.push_back(section);
        begin = end;
    }
    list_->SetSizer(sizer);
}

wxSizer* ParameterPanel::makeButtons() {
    auto* sizer = new wxBoxSizer(wxHORIZONTAL);
    const auto add = [&](const char* label, const char* hint, void (ParameterPanel::*act)()) {
        auto* button = new wxButton(this, wxID_ANY, toWx(label), wxDefaultPosition, wxDefaultSize,
                                    wxBU_EXACTFIT);
        button->SetToolTip(toWx(hint));
        button->Bind(wxEVT_BUTTON, [this, act](wxCommandEvent&) { (this->*act)(); });
        sizer->Add(button, wxSizerFlags(1).Border(wxRIGHT, FromDIP(4)));
    };
    add("Reset all", "All parameters back to their defaults", &ParameterPanel::resetAll);
    add("Load preset…", "A file as --config takes it", &ParameterPanel::load);
    add("Save as preset…", "What differs from the default, for --config", &ParameterPanel::save);
    return sizer;
}

void ParameterPanel::alignColumns() {
    int width = 0;
    for (const auto* section : sections_) width = std::max(width, section->nameWidth());
    for (auto* section : sections_) section->setNameWidth(width);
    const int scrollBar = wxSystemSettings::GetMetric(wxSYS_VSCROLL_X, this);
    list_->SetMinSize({list_->GetSizer()->CalcMin().x + scrollBar, FromDIP(120)});
}

/// After something in the list has become higher or lower.
void ParameterPanel::arrange() {
    list_->FitInside();
    list_->Layout();
}

void ParameterPanel::setConfig(const rawlog::Config& config) {
    config_ = config;
    for (auto* section : sections_) section->show(config_);
}

void ParameterPanel::enter(const rawlog::Parameter& parameter, const std::string& text) {
    rawlog::Config changed = config_;
    try {
        parameter.setText(changed, text);
        changed.validate();
    } catch (const std::invalid_argument& error) {
        setConfig(config_);  // the field turns back
        return report(error.what());
    }
    change(changed);
}

void ParameterPanel::change(const rawlog::Config& config) {
    setConfig(config);
    if (onChange) onChange(config_);
}

/// What stands in the panel, not what is set for single sensors or layers.
void ParameterPanel::resetAll() {
    rawlog::Config changed = config_;
    const rawlog::Config standard;
    for (const rawlog::Parameter& p : rawlog::parameters()) p.write(changed, p.read(standard));
    change(changed);
}

void ParameterPanel::load() {
    wxFileDialog dialog(this, "Load a preset", toWx(folder_), "", presetFiles(),
                        wxFD_OPEN | wxFD_FILE_MUST_EXIST);
    if (dialog.ShowModal() != wxID_OK) return;
    folder_ = fromWx(dialog.GetDirectory());
    try {
        change(loadPreset(fromWx(dialog.GetPath()), config_));
    } catch (const std::exception& error) {
        report(error.what());
    }
}

void ParameterPanel::save() {
    wxFileDialog dialog(this, "Save as a preset", toWx(folder_), "preset.yaml", presetFiles(),
                        wxFD_SAVE | wxFD_OVERWRITE_PROMPT);
    if (dialog.ShowModal() != wxID_OK) return;
    folder_ = fromWx(dialog.GetDirectory());
    try {
        savePreset(fromWx(dialog.GetPath()), config_);
    } catch (const std::exception& error) {
        report(error.what());
    }
}

void ParameterPanel::report(const std::string& error) const {
    if (onError) onError(error);
}

}  // namespace offmap::window
