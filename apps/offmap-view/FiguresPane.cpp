// SPDX-License-Identifier: BSD-3-Clause
#include "FiguresPane.h"

#include <utility>
#include <wx/sizer.h>

namespace offmap::window {

namespace {

wxColour colourOf(FigureRow::Mood mood, const Theme& theme) {
    switch (mood) {
        case FigureRow::Mood::Good:
            return theme.good;
        case FigureRow::Mood::Bad:
            return theme.bad;
        case FigureRow::Mood::Plain:
            break;
    }
    return theme.text;
}

}  // namespace

FiguresPane::FiguresPane(wxWindow* parent) : wxScrolledWindow(parent) {
    SetScrollRate(0, FromDIP(8));
    SetFont(GetFont().Scaled(0.92F));
    auto* grid = new wxFlexGridSizer(3, FromDIP(wxSize(8, 3)));
    grid->AddGrowableCol(2, 1);
    for (const FigureRow& row : figuresOf({}, nullptr)) lines_.push_back(addLine(row, *grid));
    auto* frame = new wxBoxSizer(wxVERTICAL);
    frame->Add(grid, 1, wxEXPAND | wxALL, FromDIP(8));
    SetSizer(frame);
    SetMinSize(FromDIP(wxSize(270, -1)));
    setTheme(*theme_);
}

FiguresPane::Line FiguresPane::addLine(const FigureRow& row, wxSizer& grid) {
    Line line{};
    line.swatch = new wxWindow(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(9, 9)));
    line.label = new wxStaticText(this, wxID_ANY, row.label);
    // Of a fixed width, so that a new figure moves nothing.
    line.value =
        new wxStaticText(this, wxID_ANY, row.value, wxDefaultPosition, FromDIP(wxSize(90, -1)),
                         wxALIGN_RIGHT | wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    line.row = row;
    grid.Add(line.swatch, 0, wxALIGN_CENTRE_VERTICAL);
    grid.Add(line.label, 0, wxALIGN_CENTRE_VERTICAL);
    grid.Add(line.value, 1, wxEXPAND);
    return line;
}

void FiguresPane::setTheme(const Theme& theme) {
    theme_ = &theme;
    SetBackgroundColour(theme.background);
    for (const Line& line : lines_) colour(line);
    Refresh();
}

void FiguresPane::colour(const Line& line) {
    const auto& reason = line.row.reason;
    line.swatch->SetBackgroundColour(reason ? toWx(theme_->palette.of(*reason))
                                            : theme_->background);
    line.label->SetForegroundColour(theme_->subtle);
    line.value->SetForegroundColour(colourOf(line.row.mood, *theme_));
}

void FiguresPane::show(const live::LiveFigures& figures, const live::LiveFramePtr& frame) {
    std::vector<FigureRow> rows = figuresOf(figures, frame.get());
    for (size_t i = 0; i < lines_.size(); ++i) show(lines_[i], std::move(rows[i]));
}

void FiguresPane::show(Line& line, FigureRow row) {
    const bool sameMood = row.mood == line.row.mood;
    const bool sameValue = row.value == line.row.value;
    line.row = std::move(row);
    if (!sameMood) colour(line);
    if (sameValue) return;
    const wxString text = wxString::FromUTF8(line.row.value);
    line.value->SetLabelText(text);
    // Where it may be cut short.
    constexpr size_t wide = 24;
    line.value->SetToolTip(text.length() > wide ? text : wxString());
}

void FiguresPane::clear() { show({}, nullptr); }

}  // namespace offmap::window
