// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPane.h"

#include "AxisTicks.h"
#include "Lettering.h"
#include "PlanPicture.h"

#include <offmap/maps/MapBounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <wx/brush.h>
#include <wx/menu.h>
#include <wx/pen.h>

namespace offmap::window {

namespace {

constexpr double zoomPerNotch = 1.2;
constexpr double deviations = 3;  // of the ellipses
constexpr double furthest = 1e6;  // [px] beyond, what draws the shapes loses count

bool nearPane(const Pixel& pixel) {
    return std::abs(pixel.x) < furthest && std::abs(pixel.y) < furthest;
}

void drawOutline(wxGraphicsContext& canvas, const std::vector<Pixel>& corners) {
    if (corners.empty() || !std::all_of(corners.begin(), corners.end(), nearPane)) return;
    wxGraphicsPath path = canvas.CreatePath();
    path.MoveToPoint(corners[0].x, corners[0].y);
    for (const Pixel& corner : corners) path.AddLineToPoint(corner.x, corner.y);
    path.CloseSubpath();
    canvas.DrawPath(path);
}

/// An arrow head with its point ahead. \param size [px] from the place to the point
std::vector<Pixel> arrowAt(const Pixel& place, double heading, double size) {
    struct Polar {
        double radius, angle;
    };
    constexpr std::array<Polar, 4> corners{{{1, 0}, {0.85, 2.5}, {0.3, M_PI}, {0.85, -2.5}}};
    std::vector<Pixel> arrow;
    for (const Polar& corner : corners) {
        const double angle = heading + corner.angle, radius = size * corner.radius;
        arrow.push_back({place.x + radius * std::cos(angle), place.y - radius * std::sin(angle)});
    }
    return arrow;
}

}  // namespace

PlanPane::PlanPane(wxWindow* parent) : DrawnPane(parent, {200, 160}) {
    SetWindowStyle(GetWindowStyle() | wxWANTS_CHARS);
    Bind(wxEVT_SIZE, &PlanPane::onSize, this);
    for (const auto& type : {wxEVT_LEFT_DOWN, wxEVT_LEFT_UP, wxEVT_MOTION}) {
        Bind(type, &PlanPane::onDrag, this);
    }
    Bind(wxEVT_MOUSE_CAPTURE_LOST, [](wxMouseCaptureLostEvent&) {});
    Bind(wxEVT_MOUSEWHEEL, &PlanPane::onWheel, this);
    Bind(wxEVT_KEY_DOWN, &PlanPane::onKey, this);
    Bind(wxEVT_CONTEXT_MENU, [this](wxContextMenuEvent&) { onMenu(); });
    Bind(wxEVT_LEFT_DCLICK, [this](wxMouseEvent& event) {
        const auto x = static_cast<double>(event.GetX()), y = static_cast<double>(event.GetY());
        if (onLookAt) onLookAt(view_.toMap({x, y}));
    });
}

void PlanPane::setTheme(const Theme& theme) {
    wallsDrawn_ = false;
    DrawnPane::setTheme(theme);
}

void PlanPane::setMap(std::shared_ptr<const core::LineMap> map) {
    map_ = std::move(map);
    wallsDrawn_ = false;
    fitMap();
}

void PlanPane::show(const live::LiveFramePtr& frame) {
    if (frame == frame_) return;
    frame_ = frame;
    scan_.reset();
    if (frame_) {
        const PlanScan poses = planPosesOf(*frame_);
        const auto& best = poses.refined ? poses.refined : poses.stated;
        if (best) path_.add(best->place, frame_->reduced.record.time);
    }
    Refresh(false);
}

void PlanPane::clearTrajectory() {
    path_.clear();
    Refresh(false);
}

void PlanPane::fitMap() {
    fitted_ = true;
    if (map_ && !map_->walls().empty()) view_.fit(maps::boundsOfAll(map_->walls()));
    Refresh(false);
}

void PlanPane::draw(wxGraphicsContext& canvas, const wxSize& size) {
    if (frame_ && !scan_) scan_ = planScanOf(*frame_);
    drawWalls(canvas, size);
    drawPath(canvas);
    if (scan_) {
        drawDots(canvas, view_, scan_->kept, toWx(theme().palette.kept));
        if (scan_->stated) drawPose(canvas, *scan_->stated, toWx(theme().palette.sensor));
        if (scan_->refined) drawPose(canvas, *scan_->refined, toWx(theme().palette.refined));
    }
    drawScaleBar(canvas);
}

void PlanPane::drawWalls(wxGraphicsContext& canvas, const wxSize& size) {
    if (!map_) return;
    if (!wallsDrawn_ || !(wallsView_ == view_)) {
        walls_ = pictureOfWalls(*map_, view_, theme().background, toWx(theme().palette.wall),
                                GetContentScaleFactor());
        wallsView_ = view_;
        wallsDrawn_ = true;
    }
    canvas.DrawBitmap(walls_, 0, 0, size.x, size.y);
}

void PlanPane::drawPath(wxGraphicsContext& canvas) {
    const core::WallBounds shown = view_.visible();
    const auto& places = path_.places();
    wxGraphicsPath path = canvas.CreatePath();
    Pixel last{-1, -1};
    for (size_t i = 1; i < places.size(); ++i) {
        if (places[i].begins) continue;
        const auto part = clipped({places[i - 1].place, places[i].place}, shown);
        if (!part) continue;
        const Pixel from = view_.toPixel(part->point1), to = view_.toPixel(part->point2);
        if (std::hypot(from.x - last.x, from.y - last.y) > 1) path.MoveToPoint(from.x, from.y);
        path.AddLineToPoint(to.x, to.y);
        last = to;
    }
    canvas.SetPen(wxPen(theme().accent, FromDIP(1)));
    canvas.StrokePath(path);
}

void PlanPane::drawPose(wxGraphicsContext& canvas, const PlanPose& pose, const wxColour& colour) {
    std::vector<Pixel> ellipse;
    for (const auto& place : ellipseOutline(pose, deviations)) {
        ellipse.push_back(view_.toPixel(place));
    }
    canvas.SetPen(wxPen(colour, 1));
    canvas.SetBrush(wxBrush(wxColour(colour.Red(), colour.Green(), colour.Blue(), 60)));
    drawOutline(canvas, ellipse);
    canvas.SetPen(wxPen(theme().background, 1));
    canvas.SetBrush(wxBrush(colour));
    drawOutline(canvas, arrowAt(view_.toPixel(pose.place), pose.heading, FromDIP(11)));
}

void PlanPane::drawScaleBar(wxGraphicsContext& canvas) {
    const double metres = roundDown(FromDIP(100) / view_.scale());
    const double left = FromDIP(12), right = left + metres * view_.scale();
    const double bottom = view_.height() - FromDIP(12), rise = FromDIP(4);
    canvas.SetPen(wxPen(theme().text, 1));
    wxGraphicsPath bar = canvas.CreatePath();
    bar.MoveToPoint(left, bottom - rise);
    bar.AddLineToPoint(left, bottom);
    bar.AddLineToPoint(right, bottom);
    bar.AddLineToPoint(right, bottom - rise);
    canvas.StrokePath(bar);
    canvas.SetFont(smallFont(*this), theme().text);
    drawText(canvas, lengthLabel(metres), 0.5 * (left + right), bottom - FromDIP(9),
             Beside::Centre);
}

void PlanPane::onSize(wxSizeEvent& event) {
    const wxSize size = GetClientSize();
    view_.setSize(size.x, size.y);
    if (fitted_) fitMap();
    event.Skip();
}

void PlanPane::onDrag(wxMouseEvent& event) {
    const wxPoint moved = event.GetPosition() - dragged_;
    dragged_ = event.GetPosition();
    if (event.LeftDown()) {
        SetFocus();
        CaptureMouse();
    } else if (event.Dragging() && HasCapture()) {
        view_.pan(moved.x, moved.y);
        fitted_ = false;
        Refresh(false);
    }
    if (event.LeftUp() && HasCapture()) ReleaseMouse();
}

void PlanPane::onWheel(wxMouseEvent& event) {
    if (event.GetWheelDelta() == 0) return;
    const double notches = static_cast<double>(event.GetWheelRotation()) / event.GetWheelDelta();
    view_.zoom(std::pow(zoomPerNotch, notches),
               {static_cast<double>(event.GetX()), static_cast<double>(event.GetY())});
    fitted_ = false;
    Refresh(false);
}

void PlanPane::onKey(wxKeyEvent& event) {
    if (event.GetKeyCode() == 'F' && !event.HasAnyModifiers()) return fitMap();
    event.Skip();
}

void PlanPane::onMenu() {
    wxMenu menu;
    menu.Append(wxID_ZOOM_FIT, "Fit the map\tF");
    menu.Bind(wxEVT_MENU, [this](wxCommandEvent&) { fitMap(); });
    PopupMenu(&menu);
}

}  // namespace offmap::window
