// SPDX-License-Identifier: BSD-3-Clause
#include "LiveDialog.h"

#include "WxText.h"
#include "input/UsageError.h"

#include <wx/button.h>
#include <wx/choice.h>
#include <wx/filedlg.h>
#include <wx/panel.h>
#include <wx/sizer.h>
#include <wx/stattext.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

constexpr int errorWidth = 420;  // [DIP]

const char* filesOf(LiveKind kind) {
    switch (kind) {
        case LiveKind::Sensors:
            return "Sensors (*.ini)|*.ini";
        case LiveKind::Capture:
            return "Captures (*.pcap, *.pcapng)|*.pcap;*.pcapng";
        default:
            return "Rawlogs (*.rawlog)|*.rawlog|All files|*";
    }
}

std::string textOf(const wxTextCtrl& field) { return fromWx(field.GetValue()); }

wxChoice* makeChoice(wxWindow* parent, std::initializer_list<const char*> names) {
    auto* choice = new wxChoice(parent, wxID_ANY);
    for (const char* name : names) choice->Append(toWx(name));
    return choice;
}

}  // namespace

LiveDialog::LiveDialog(wxWindow* parent, const LiveEntries& entries, const Theme& theme)
    : wxDialog(parent, wxID_ANY, "Watch a live source"),
      grid_(new wxFlexGridSizer(2, FromDIP(wxSize(12, 6)))),
      kind_(makeChoice(this, {"Velodyne on the network", "Sensors of an INI file",
                              "Capture of a Velodyne", "Rawlog while it is written"})),
      poses_(makeChoice(
          this, {"as the source tells", "the robot stands at", "the robot moves, beginning at"})),
      port_(new wxTextCtrl(this, wxID_ANY)),
      label_(new wxTextCtrl(this, wxID_ANY)),
      error_(new wxStaticText(this, wxID_ANY, "")) {
    grid_->AddGrowableCol(1);
    addRow("Source", kind_);
    portRow_ = addRow("UDP port", port_);
    fileRow_ = addRow("File", makeFileField(entries.file));
    labelRow_ = addRow("Sensor label", label_);
    addRow("Poses", poses_);
    poseRow_ = addRow("", makePoseFields(entries));
    error_->SetForegroundColour(theme.bad);
    kind_->Bind(wxEVT_CHOICE, [this](wxCommandEvent&) { arrange(); });
    poses_->Bind(wxEVT_CHOICE, [this](wxCommandEvent&) { arrange(); });
    Bind(
        wxEVT_BUTTON, [this](wxCommandEvent&) { accept(); }, wxID_OK);

    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(grid_, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(12)));
    sizer->Add(error_, wxSizerFlags().Expand().Border(wxLEFT | wxRIGHT, FromDIP(12)));
    sizer->Add(CreateStdDialogButtonSizer(wxOK | wxCANCEL),
               wxSizerFlags().Expand().Border(wxALL, FromDIP(12)));
    SetSizer(sizer);
    FindWindow(wxID_OK)->SetLabel("Watch");
    show(entries);
    CentreOnParent();
}

LiveDialog::Row LiveDialog::addRow(const char* name, wxWindow* field) {
    auto* text = new wxStaticText(this, wxID_ANY, toWx(name));
    grid_->Add(text, wxSizerFlags().CentreVertical());
    grid_->Add(field, wxSizerFlags().Expand());
    return {text, field};
}

wxWindow* LiveDialog::makeFileField(const std::string& file) {
    auto* panel = new wxPanel(this);
    file_ =
        new wxTextCtrl(panel, wxID_ANY, toWx(file), wxDefaultPosition, FromDIP(wxSize(320, -1)));
    auto* button = new wxButton(panel, wxID_ANY, toWx("Browse…"), wxDefaultPosition, wxDefaultSize,
                                wxBU_EXACTFIT);
    button->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { browse(); });
    auto* sizer = new wxBoxSizer(wxHORIZONTAL);
    sizer->Add(file_, wxSizerFlags(1).CentreVertical());
    sizer->Add(button, wxSizerFlags().CentreVertical().Border(wxLEFT, FromDIP(6)));
    panel->SetSizer(sizer);
    return panel;
}

wxWindow* LiveDialog::makePoseFields(const LiveEntries& entries) {
    auto* panel = new wxPanel(this);
    auto* sizer = new wxBoxSizer(wxHORIZONTAL);
    const auto add = [&](const char* name, const char* unit, const std::string& text) {
        auto* field = new wxTextCtrl(panel, wxID_ANY, toWx(text), wxDefaultPosition,
                                     FromDIP(wxSize(72, -1)), wxTE_RIGHT);
        const auto flags = wxSizerFlags().CentreVertical().Border(wxRIGHT, FromDIP(5));
        sizer->Add(new wxStaticText(panel, wxID_ANY, toWx(name)), flags);
        sizer->Add(field, wxSizerFlags(flags).Proportion(1));
        sizer->Add(new wxStaticText(panel, wxID_ANY, toWx(unit)), flags);
        sizer->AddSpacer(FromDIP(6));
        return field;
    };
    x_ = add("x", "m", entries.x);
    y_ = add("y", "m", entries.y);
    yaw_ = add("yaw", "°", entries.yaw);
    panel->SetSizer(sizer);
    return panel;
}

void LiveDialog::show(const LiveEntries& entries) {
    kind_->SetSelection(static_cast<int>(entries.kind));
    poses_->SetSelection(static_cast<int>(entries.poses));
    port_->SetValue(toWx(entries.port));
    label_->SetValue(toWx(entries.label));
    arrange();
}

/// Only the fields that matter for what is chosen.
void LiveDialog::arrange() {
    const LiveEntries now = entries();
    const auto setVisible = [](const Row& row, bool visible) {
        row.name->Show(visible);
        row.field->Show(visible);
    };
    setVisible(portRow_, !hasFile(now.kind));
    setVisible(fileRow_, hasFile(now.kind));
    setVisible(labelRow_, hasLabel(now.kind));
    setVisible(poseRow_, now.poses != LivePoseKind::FromSource);
    GetSizer()->SetSizeHints(this);
    Fit();
}

LiveEntries LiveDialog::entries() const {
    return {static_cast<LiveKind>(kind_->GetSelection()),
            textOf(*port_),
            textOf(*file_),
            textOf(*label_),
            static_cast<LivePoseKind>(poses_->GetSelection()),
            textOf(*x_),
            textOf(*y_),
            textOf(*yaw_)};
}

void LiveDialog::browse() {
    wxFileDialog dialog(this, "Source", "", "", filesOf(entries().kind),
                        wxFD_OPEN | wxFD_FILE_MUST_EXIST);
    if (dialog.ShowModal() == wxID_OK) file_->SetValue(dialog.GetPath());
}

void LiveDialog::accept() {
    try {
        choice_ = liveChoiceOf(entries());
        EndModal(wxID_OK);
    } catch (const app::UsageError& error) {
        error_->SetLabel(toWx(error.what()));
        error_->Wrap(FromDIP(errorWidth));
        arrange();
    }
}

}  // namespace offmap::window
