// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterSection.h"

#include "ParameterFacts.h"
#include "WxText.h"

#include <fmt/format.h>

#include <algorithm>
#include <wx/button.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

namespace offmap::window {

ParameterSection::ParameterSection(wxWindow* parent, std::span<const rawlog::Parameter> parameters,
                                   bool open)
    : wxPanel(parent),
      heading_(headingOf(sectionOf(parameters.front()))),
      open_(open),
      head_(new wxButton(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                         wxBU_LEFT | wxBORDER_NONE)),
      body_(new wxPanel(this)),
      grid_(new wxFlexGridSizer(4, FromDIP(wxSize(6, 2)))) {
    grid_->AddGrowableCol(1);
    for (const rawlog::Parameter& p : parameters) {
        auto row = std::make_unique<ParameterRow>(*body_, *grid_, p);
        row->onEnter = [this, &p](const std::string& text) { onEnter(p, text); };
        rows_.push_back(std::move(row));
    }
    auto* inside = new wxBoxSizer(wxVERTICAL);
    inside->Add(grid_, wxSizerFlags(1).Expand().Border(wxLEFT, FromDIP(10)));
    body_->SetSizer(inside);
    head_->SetFont(GetFont().Bold());
    head_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { fold(); });

    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(head_, wxSizerFlags().Expand().Border(wxLEFT, FromDIP(4)));
    sizer->Add(body_, wxSizerFlags().Expand().Border(wxBOTTOM, FromDIP(6)));
    SetSizer(sizer);
    body_->Show(open_);
    label();
}

void ParameterSection::show(const rawlog::Config& config) {
    changed_ = 0;
    for (const auto& row : rows_) {
        row->show(config);
        if (!isDefault(row->parameter(), config)) ++changed_;
    }
    label();
}

void ParameterSection::filter(const std::string& text) {
    filter_ = text;
    bool any = false;
    for (const auto& row : rows_) {
        const bool found = isFoundBy(row->parameter(), text);
        row->setVisible(found);
        any = any || found;
    }
    body_->Show(text.empty() ? open_ : any);
    Show(any);
    label();
}

void ParameterSection::fold() {
    if (!filter_.empty()) return;
    open_ = !open_;
    body_->Show(open_);
    label();
    onFold();
}

void ParameterSection::label() {
    const std::string changed = changed_ == 0 ? "" : fmt::format("  ({} changed)", changed_);
    const wxString text =
        toWx(fmt::format("{} {}{}", body_->IsShown() ? "▾" : "▸", heading_, changed));
    if (head_->GetLabel() != text) head_->SetLabel(text);
}

int ParameterSection::nameWidth() const {
    int width = 0;
    for (const auto& row : rows_) width = std::max(width, row->nameWidth());
    return width;
}

void ParameterSection::setNameWidth(int width) {
    for (const auto& row : rows_) row->setNameWidth(width);
}

}  // namespace offmap::window
