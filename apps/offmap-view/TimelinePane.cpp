// SPDX-License-Identifier: BSD-3-Clause
#include "TimelinePane.h"

#include "AxisTicks.h"
#include "Curves.h"
#include "Lettering.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <wx/brush.h>
#include <wx/pen.h>

namespace offmap::window {

namespace {

// [DIP] around the strip
constexpr int nameWidth = 136, scaleWidth = 50, topMargin = 7, numberHeight = 24;
constexpr double joinedWidth = 3;  // [px] less than that without a turn is no gap

wxColour seeThrough(const wxColour& colour, unsigned char alpha) {
    return {colour.Red(), colour.Green(), colour.Blue(), alpha};
}

}  // namespace

TimelinePane::TimelinePane(wxWindow* parent) : DrawnPane(parent, {400, 78}) {
    SetWindowStyle(GetWindowStyle() | wxWANTS_CHARS);
    for (const auto& type : {wxEVT_LEFT_DOWN, wxEVT_LEFT_UP, wxEVT_MOTION}) {
        Bind(type, &TimelinePane::onMouse, this);
    }
    Bind(wxEVT_MOUSE_CAPTURE_LOST, [](wxMouseCaptureLostEvent&) {});
    Bind(wxEVT_KEY_DOWN, &TimelinePane::onKey, this);
}

void TimelinePane::setTurns(uint64_t count) {
    history_.setTurns(count);
    explained_ = nothingExplained;
    setPosition(0);
    Refresh(false);
}

void TimelinePane::add(uint64_t number, double removedShare, double milliseconds, bool suspect) {
    history_.add(number, {removedShare, milliseconds, suspect});
    if (number == explained_) explained_ = nothingExplained;
    Refresh(false);
}

void TimelinePane::setPosition(uint64_t number) {
    if (number == position_) return;
    position_ = number;
    Refresh(false);
}

void TimelinePane::clear() {
    history_.clear();
    explained_ = nothingExplained;
    Refresh(false);
}

wxRect2DDouble TimelinePane::stripOf(const wxSize& size) const {
    const wxSize before = FromDIP(wxSize(nameWidth, topMargin));
    const wxSize after = FromDIP(wxSize(scaleWidth, numberHeight));
    return wxRect2DDouble(before.x, before.y, std::max(size.x - before.x - after.x, 1),
                          std::max(size.y - before.y - after.y, 1));
}

double TimelinePane::greatestMilliseconds() const {
    const double from = static_cast<double>(history_.shownFrom());
    return roundUp(std::max(history_.milliseconds().greatest(from).value_or(1), 0.01));
}

void TimelinePane::draw(wxGraphicsContext& canvas, const wxSize& size) {
    const wxRect2DDouble strip = stripOf(size);
    canvas.SetPen(*wxTRANSPARENT_PEN);
    canvas.SetBrush(wxBrush(seeThrough(theme().grid, 110)));
    canvas.DrawRectangle(strip.m_x, strip.m_y, strip.m_width, strip.m_height);
    drawNumbers(canvas, strip);
    drawCurves(canvas, strip);
    drawSuspects(canvas, strip);
    drawPosition(canvas, strip);
    drawNames(canvas, strip);
}

void TimelinePane::drawCurves(wxGraphicsContext& canvas, const wxRect2DDouble& strip) {
    // A turn is as wide as the next one is away, and its place in the middle.
    const double from = static_cast<double>(history_.shownFrom()) - 0.5;
    const double to = static_cast<double>(history_.shownTo()) - 0.5;
    const auto count = static_cast<size_t>(strip.m_width);
    const double turnWidth = strip.m_width / (to - from);
    const double perPlace = static_cast<double>(history_.turnsPerPlace());
    const double gap = std::max(1.5 * perPlace, joinedWidth / turnWidth);
    fillCurve(canvas, {strip, 1}, history_.removedShare().columns(from, to, count, gap),
              0.5 * std::max(turnWidth * perPlace, 1.0), seeThrough(theme().removed, 150));
    drawCurve(canvas, {strip, greatestMilliseconds()},
              history_.milliseconds().columns(from, to, count, gap), theme().timing);
}

void TimelinePane::drawSuspects(wxGraphicsContext& canvas, const wxRect2DDouble& strip) {
    const double from = static_cast<double>(history_.shownFrom()) - 0.5;
    const double to = static_cast<double>(history_.shownTo()) - 0.5;
    const double width = std::max(strip.m_width / (to - from), 2.0);
    const double top = strip.GetBottom() + FromDIP(1), height = FromDIP(4);
    canvas.SetPen(*wxTRANSPARENT_PEN);
    canvas.SetBrush(wxBrush(theme().bad));
    for (const CurveColumn& column : history_.suspects().columns(
             from, to, static_cast<size_t>(strip.m_width), static_cast<double>(to - from))) {
        if (column.high == 0) continue;
        const double middle = strip.m_x + static_cast<double>(column.column) + 0.5;
        canvas.DrawRectangle(middle - 0.5 * width, top, width, height);
    }
}

void TimelinePane::drawPosition(wxGraphicsContext& canvas, const wxRect2DDouble& strip) {
    const double x = std::floor(strip.m_x + history_.shareOf(position_) * strip.m_width);
    const double half = FromDIP(4);
    canvas.SetPen(*wxTRANSPARENT_PEN);
    canvas.SetBrush(wxBrush(theme().accent));
    canvas.DrawRectangle(x - 0.5, strip.m_y, 2, strip.m_height);
    wxGraphicsPath handle = canvas.CreatePath();
    handle.MoveToPoint(x + 0.5 - half, strip.m_y - half);
    handle.AddLineToPoint(x + 0.5 + half, strip.m_y - half);
    handle.AddLineToPoint(x + 0.5, strip.m_y + 0.5 * half);
    handle.CloseSubpath();
    canvas.FillPath(handle);
}

void TimelinePane::drawNames(wxGraphicsContext& canvas, const wxRect2DDouble& strip) {
    const auto now = history_.at(position_);
    const double left = FromDIP(10), right = strip.m_x - FromDIP(10);
    const auto line = [&](const char* name, const std::string& value, double share,
                          const wxColour& colour) {
        const double y = strip.m_y + share * strip.m_height;
        canvas.SetFont(smallFont(*this), colour);
        drawText(canvas, name, left, y);
        drawText(canvas, value, right, y, Beside::Left);
    };
    line("removed", now ? fmt::format("{:.1f} %", 100 * now->removedShare) : "-", 0.2,
         theme().removed);
    line("reduce", now ? fmt::format("{:.2f} ms", now->milliseconds) : "-", 0.6, theme().timing);
    const double axis = strip.GetRight() + FromDIP(5);
    drawText(canvas, fmt::format("{:g} ms", greatestMilliseconds()), axis, strip.m_y + FromDIP(4));
    drawText(canvas, "0", axis, strip.GetBottom() - FromDIP(3));
}

void TimelinePane::drawNumbers(wxGraphicsContext& canvas, const wxRect2DDouble& strip) {
    canvas.SetFont(smallFont(*this), theme().subtle);
    const double y = strip.GetBottom() + FromDIP(14);
    const auto most = static_cast<size_t>(strip.m_width / FromDIP(80)) + 1;
    canvas.SetPen(wxPen(theme().grid, 1));
    for (const AxisTick& tick : axisTicks(static_cast<double>(history_.shownFrom() + 1),
                                          static_cast<double>(history_.shownTo()), most, true)) {
        const double share = history_.shareOf(static_cast<uint64_t>(tick.value) - 1);
        const double x = std::floor(strip.m_x + share * strip.m_width) + 0.5;
        canvas.StrokeLine(x, strip.m_y, x, strip.GetBottom());
        drawText(canvas, tick.label, x, y, Beside::Centre);
    }
}

uint64_t TimelinePane::turnUnder(int x) const {
    const wxRect2DDouble strip = stripOf(GetClientSize());
    return history_.turnAt((x - strip.m_x) / strip.m_width);
}

void TimelinePane::onMouse(wxMouseEvent& event) {
    const uint64_t number = turnUnder(event.GetX());
    if (event.LeftDown()) {
        SetFocus();
        CaptureMouse();
    }
    if (event.LeftIsDown() && HasCapture()) jumpTo(number);
    if (event.LeftUp() && HasCapture()) ReleaseMouse();
    explainTurn(number);
}

void TimelinePane::onKey(wxKeyEvent& event) {
    const auto go = [&](int64_t steps) { jumpTo(history_.steppedFrom(position_, steps)); };
    switch (event.GetKeyCode()) {
        // clang-format off
        case WXK_LEFT: return go(-1);
        case WXK_RIGHT: return go(1);
        case WXK_PAGEUP: return go(-10);
        case WXK_PAGEDOWN: return go(10);
        case WXK_HOME: return jumpTo(history_.shownFrom());
        case WXK_END: return jumpTo(history_.shownTo() - 1);
        default: event.Skip();
            // clang-format on
    }
}

void TimelinePane::jumpTo(uint64_t number) {
    if (number == position_) return;
    setPosition(number);
    if (onJump) onJump(number);
}

void TimelinePane::explainTurn(uint64_t number) {
    if (number == explained_) return;
    explained_ = number;
    const auto figures = history_.at(number);
    const char* about = history_.turnsPerPlace() > 1 ? "about turn" : "turn";
    const std::string name = fmt::format("{} {}", about, rawlog::grouped(number + 1));
    SetToolTip(
        wxString::FromUTF8(figures ? fmt::format("{}: {:.1f} % removed, {:.2f} ms{}", name,
                                                 100 * figures->removedShare, figures->milliseconds,
                                                 figures->suspect ? ", does not fit the map" : "")
                                   : name));
}

}  // namespace offmap::window
