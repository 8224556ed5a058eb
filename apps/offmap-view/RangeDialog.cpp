// SPDX-License-Identifier: BSD-3-Clause
#include "RangeDialog.h"

#include <algorithm>
#include <limits>
#include <wx/sizer.h>
#include <wx/spinctrl.h>
#include <wx/stattext.h>

namespace offmap::window {

RangeDialog::RangeDialog(wxWindow* parent, uint64_t turns)
    : wxDialog(parent, wxID_ANY, "Export reduced turns") {
    constexpr uint64_t most = std::numeric_limits<int>::max();
    const int end = static_cast<int>(turns == 0 ? most : std::min(turns, most));
    auto* grid = new wxFlexGridSizer(2, FromDIP(wxSize(12, 8)));
    first_ = addField(*grid, "First turn", 1, end);
    last_ = addField(*grid, "Last turn", end, end);
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(grid, 0, wxALL, FromDIP(16));
    sizer->Add(CreateSeparatedButtonSizer(wxOK | wxCANCEL), 0, wxEXPAND | wxALL, FromDIP(10));
    SetSizerAndFit(sizer);
    CentreOnParent();
}

wxSpinCtrl* RangeDialog::addField(wxSizer& grid, const char* name, int value, int most) {
    grid.Add(new wxStaticText(this, wxID_ANY, name), 0, wxALIGN_CENTER_VERTICAL);
    auto* field = new wxSpinCtrl(this, wxID_ANY);
    field->SetRange(1, most);
    field->SetValue(value);
    grid.Add(field, 1, wxEXPAND);
    return field;
}

TurnRange RangeDialog::range() const {
    const auto [first, last] = std::minmax({first_->GetValue(), last_->GetValue()});
    return {static_cast<uint64_t>(first) - 1, static_cast<uint64_t>(last) - 1};
}

}  // namespace offmap::window
