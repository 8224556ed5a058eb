// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterRow.h"

#include "ParameterFacts.h"
#include "WxText.h"

#include <wx/button.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

namespace offmap::window {

namespace {

void setBold(wxWindow& window, bool bold) {
    const wxFont font = window.GetParent()->GetFont();
    window.SetFont(bold ? font.Bold() : font);
}

wxString unitText(const rawlog::Parameter& p) {
    if (p.unit == "-") return {};
    return toWx(p.unit == "deg" ? "°" : p.unit);
}

}  // namespace

ParameterRow::ParameterRow(wxWindow& parent, wxFlexGridSizer& grid,
                           const rawlog::Parameter& parameter)
    : parameter_(parameter),
      name_(new wxStaticText(&parent, wxID_ANY, toWx(nameOf(parameter)), wxDefaultPosition,
                             wxDefaultSize, wxST_ELLIPSIZE_END)),
      editor_(makeEditor(parent, parameter)),
      unit_(new wxStaticText(&parent, wxID_ANY, unitText(parameter))),
      reset_(new wxButton(&parent, wxID_ANY, toWx("↺"), wxDefaultPosition, wxDefaultSize,
                          wxBU_EXACTFIT | wxBORDER_NONE)) {
    for (wxWindow* window : {static_cast<wxWindow*>(name_), &editor_->control()}) {
        window->SetToolTip(toWx(hintOf(parameter)));
    }
    const std::string standard = parameter.text(rawlog::Config{});
    reset_->SetToolTip(toWx("Back to " + standard));
    reset_->Bind(wxEVT_BUTTON, [this, standard](wxCommandEvent&) { onEnter(standard); });
    editor_->onEnter = [this](const std::string& text) { onEnter(text); };
    editor_->control().SetName(toWx(parameter.key));
    reset_->Disable();
    unit_->SetMinSize({unit_->GetTextExtent("mm").x, -1});  // one width for all rows

    const bool stretches = parameter.kind != rawlog::ParameterKind::Switch;
    grid.Add(name_, wxSizerFlags().CentreVertical().Expand());
    grid.Add(&editor_->control(), wxSizerFlags().CentreVertical().Align(stretches ? wxEXPAND : 0));
    grid.Add(unit_, wxSizerFlags().CentreVertical());
    grid.Add(reset_, wxSizerFlags().CentreVertical());
}

void ParameterRow::show(const rawlog::Config& config) {
    const bool changed = !isDefault(parameter_, config);
    editor_->show(parameter_.text(config));
    if (changed == reset_->IsEnabled()) return;
    setBold(*name_, changed);
    reset_->Enable(changed);
}

void ParameterRow::setVisible(bool visible) {
    for (wxWindow* window : {static_cast<wxWindow*>(name_), &editor_->control(),
                             static_cast<wxWindow*>(unit_), static_cast<wxWindow*>(reset_)}) {
        window->Show(visible);
    }
}

int ParameterRow::nameWidth() const {
    int width = 0;
    const wxFont bold = name_->GetParent()->GetFont().Bold();
    name_->GetTextExtent(name_->GetLabel(), &width, nullptr, nullptr, nullptr, &bold);
    return width;
}

void ParameterRow::setNameWidth(int width) { name_->SetMinSize({width, -1}); }

}  // namespace offmap::window
