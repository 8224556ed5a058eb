// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FigureRows.h"
#include "Theme.h"

#include <vector>
#include <wx/scrolwin.h>
#include <wx/stattext.h>

namespace offmap::window {

/// How a reduction is going and what became of its latest turn, in figures.
class FiguresPane : public wxScrolledWindow {
 public:
    explicit FiguresPane(wxWindow* parent);

    void setTheme(const Theme& theme);
    /// \param frame null: no turn yet
    void show(const live::LiveFigures& figures, const live::LiveFramePtr& frame);
    void clear();

 private:
    /// The controls of one figure, and what they show.
    struct Line {
        wxWindow* swatch;
        wxStaticText *label, *value;
        FigureRow row;
    };
    Line addLine(const FigureRow& row, wxSizer& grid);
    void show(Line& line, FigureRow row);
    void colour(const Line& line);

    std::vector<Line> lines_;
    const Theme* theme_ = &Theme::darkOne();
};

}  // namespace offmap::window
