// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnPane.h"
#include "TurnHistory.h"

#include <functional>

namespace offmap::window {

/// A strip along the log: the removed share and how long reducing took, turn by turn, and the place
/// now. To its user, turns count from 1. A click, a drag and the keys go to another turn.
class TimelinePane : public DrawnPane {
 public:
    explicit TimelinePane(wxWindow* parent);

    /// Forgets all turns. \param count of the log; 0: live, which shows the newest ones
    void setTurns(uint64_t count);
    /// \param removedShare [0, 1] \param milliseconds [ms]
    void add(uint64_t number, double removedShare, double milliseconds, bool suspect);
    void setPosition(uint64_t number);
    void clear();

    std::function<void(uint64_t)> onJump;  ///< to the turn of that number

 protected:
    void draw(wxGraphicsContext& canvas, const wxSize& size) override;

 private:
    wxRect2DDouble stripOf(const wxSize& size) const;
    void drawCurves(wxGraphicsContext& canvas, const wxRect2DDouble& strip);
    void drawSuspects(wxGraphicsContext& canvas, const wxRect2DDouble& strip);
    void drawPosition(wxGraphicsContext& canvas, const wxRect2DDouble& strip);
    void drawNames(wxGraphicsContext& canvas, const wxRect2DDouble& strip);
    void drawNumbers(wxGraphicsContext& canvas, const wxRect2DDouble& strip);
    double greatestMilliseconds() const;

    void onMouse(wxMouseEvent& event);
    void onKey(wxKeyEvent& event);
    void jumpTo(uint64_t number);
    uint64_t turnUnder(int x) const;
    void explainTurn(uint64_t number);

    TurnHistory history_;
    uint64_t position_ = 0;
    static constexpr uint64_t nothingExplained = ~uint64_t{0};
    uint64_t explained_ = nothingExplained;  // the turn that the tooltip tells of
};

}  // namespace offmap::window
