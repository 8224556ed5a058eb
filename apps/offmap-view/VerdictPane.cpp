// SPDX-License-Identifier: BSD-3-Clause
#include "VerdictPane.h"

#include "WxText.h"

#include <algorithm>
#include <wx/sizer.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

constexpr const char* hint = "Click a point to see why it was kept or removed.";

/// [0.1 mm], as the toolkit wants indents and tabs.
int inTenthsOfMillimetres(const wxWindow& window, int pixels) {
    return static_cast<int>(pixels * 254.0 / window.GetDPI().x);
}

int widestName(const wxWindow& window, const VerdictPane::Lines& lines) {
    int widest = 0;
    for (const auto& [name, value] : lines) {
        widest = std::max(widest, window.GetTextExtent(toWx(name)).x);
    }
    return widest;
}

}  // namespace

VerdictPane::VerdictPane(wxWindow* parent)
    : wxPanel(parent),
      text_(new wxTextCtrl(
          this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
          wxTE_MULTILINE | wxTE_READONLY | wxTE_RICH2 | wxTE_WORDWRAP | wxBORDER_NONE)) {
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(text_, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(6)));
    SetSizer(sizer);
    setTheme(*theme_);
}

void VerdictPane::show(const Lines& lines, const std::string& sentence) {
    if (lines == lines_ && sentence == sentence_) return;
    lines_ = lines;
    sentence_ = sentence;
    write();
}

void VerdictPane::clear() { show({}, ""); }

void VerdictPane::setTheme(const Theme& theme) {
    theme_ = &theme;
    SetBackgroundColour(theme.background);
    text_->SetBackgroundColour(theme.background);
    text_->SetForegroundColour(theme.text);
    write();
    Refresh();
}

void VerdictPane::write() {
    text_->Clear();
    const wxFont font = GetFont();
    const bool empty = lines_.empty() && sentence_.empty();
    text_->SetDefaultStyle({empty ? theme_->subtle : theme_->text, theme_->background,
                            empty ? font : font.Scaled(1.15F).Bold()});
    text_->AppendText(toWx(empty ? hint : sentence_ + "\n"));
    if (!lines_.empty()) writeLines();
    text_->SetInsertionPoint(0);
    text_->ShowPosition(0);
}

void VerdictPane::writeLines() {
    const wxFont font = GetFont();
    text_->SetDefaultStyle({theme_->text, theme_->background, font.Scaled(0.5F)});
    text_->AppendText("\n");
    const int column = inTenthsOfMillimetres(*this, widestName(*this, lines_) + FromDIP(14));
    wxTextAttr style(theme_->subtle, theme_->background, font);
    style.SetLeftIndent(0, column);
    wxArrayInt tabs;
    tabs.Add(column);
    style.SetTabs(tabs);
    for (const auto& [name, value] : lines_) {
        style.SetTextColour(theme_->subtle);
        text_->SetDefaultStyle(style);
        text_->AppendText(toWx(name + "\t"));
        style.SetTextColour(theme_->text);
        text_->SetDefaultStyle(style);
        text_->AppendText(toWx(value + "\n"));
    }
}

}  // namespace offmap::window
