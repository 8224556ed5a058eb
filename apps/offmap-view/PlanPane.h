// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnPane.h"
#include "PlanPath.h"
#include "PlanScan.h"
#include "PlanView.h"

#include <offmap/core/LineMap.h>
#include <offmap/live/LiveFrame.h>

#include <functional>
#include <memory>

namespace offmap::window {

/// The map from above: walls, the robot and what it found that the map does not know. The wheel
/// zooms, a drag moves, the key F and the menu fit the map.
class PlanPane : public DrawnPane {
 public:
    explicit PlanPane(wxWindow* parent);

    void setTheme(const Theme& theme) override;
    /// Fits the view to it. \param map null: none
    void setMap(std::shared_ptr<const core::LineMap> map);
    /// \param frame null: none
    void show(const live::LiveFramePtr& frame);
    void clearTrajectory();

    std::function<void(const mrpt::math::TPoint2D&)> onLookAt;  ///< [m] a double click in the map

 protected:
    void draw(wxGraphicsContext& canvas, const wxSize& size) override;

 private:
    void drawWalls(wxGraphicsContext& canvas, const wxSize& size);
    void drawPath(wxGraphicsContext& canvas);
    void drawPose(wxGraphicsContext& canvas, const PlanPose& pose, const wxColour& colour);
    void drawScaleBar(wxGraphicsContext& canvas);

    void fitMap();
    void onSize(wxSizeEvent& event);
    void onDrag(wxMouseEvent& event);
    void onWheel(wxMouseEvent& event);
    void onKey(wxKeyEvent& event);
    void onMenu();

    std::shared_ptr<const core::LineMap> map_;
    PlanView view_;
    bool fitted_ = true;  // until the user looks elsewhere

    wxBitmap walls_;  // as drawn last, for:
    PlanView wallsView_;
    bool wallsDrawn_ = false;

    live::LiveFramePtr frame_;
    std::optional<PlanScan> scan_;  // of the frame, once drawn
    PlanPath path_;
    wxPoint dragged_;  // [px] where the pointer was
};

}  // namespace offmap::window
