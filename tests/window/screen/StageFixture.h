// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../MadeUpFrame.h"
#include "../OfficeLogs.h"
#include "DrawnPicture.h"
#include "Pump.h"
#include "ScanStage.h"

#include <gtest/gtest.h>

#include <wx/frame.h>

namespace offmap::test {

inline live::LiveFramePtr sharedMadeUpFrame() {
    return std::make_shared<live::LiveFrame>(madeUpFrame());
}

/// A stage on the screen, and a hand at it.
class StageFixture : public testing::Test {
 protected:
    StageFixture()
        : frame_(new wxFrame(nullptr, wxID_ANY, "stage", {0, 0}, {800, 500})),
          stage_(new window::ScanStage(frame_)) {
        stage_->onShown = [this](const window::Composed&) { ++shown_; };
        stage_->onPicked = [this](const view::SegmentStory* story) {
            ++picks_;
            picked_ = story ? std::optional(*story) : std::nullopt;
        };
        frame_->Show();
        frame_->Layout();
        EXPECT_TRUE(pumpUntil([&] { return picture().IsOk(); })) << "nothing is painted";
    }
    ~StageFixture() override {
        delete frame_;  // not Destroy(), which waits for a loop of events
    }

    bool shows(const live::LiveFramePtr& frame) {
        stage_->take(frame);
        return showsNow(frame);
    }
    bool showsNow(const live::LiveFramePtr& frame) {
        return pumpUntil([&] { return stage_->shown() && stage_->shown()->frame == frame; });
    }
    wxImage picture() { return stage_->canvas().picture(); }

    /// Pixels that are rather red than anything else, as only what was removed is.
    static int redIn(const wxImage& picture) {
        int red = 0;
        for (int y = 0; y < picture.GetHeight(); ++y) {
            for (int x = 0; x < picture.GetWidth(); ++x) {
                red += picture.GetRed(x, y) > 128 && picture.GetGreen(x, y) < 64 &&
                       picture.GetBlue(x, y) < 64;
            }
        }
        return red;
    }
    /// Without walls and poses, which shine through.
    void choose(const std::function<void(window::SceneChoices&)>& choose) {
        window::SceneChoices choices = stage_->choices();
        choices.shown.walls = choices.shown.ellipse = false;
        choose(choices);
        const auto before = stage_->shown();
        stage_->setChoices(choices);
        ASSERT_TRUE(pumpUntil([&] { return stage_->shown() != before; }));
    }

    /// Where a place of the map is in a picture from above.
    wxPoint pixelOf(double x, double y) const {
        const view::Camera& camera = stage_->camera();
        const auto size = stage_->canvas().pictureSize();
        const double scale = 1 / view::metresPerPixel(camera, size);
        return {static_cast<int>(std::lround(0.5 * size.width + (x - camera.target.x) * scale)),
                static_cast<int>(std::lround(0.5 * size.height - (y - camera.target.y) * scale))};
    }
    void mouse(const wxEventTypeTag<wxMouseEvent>& type, const wxPoint& place,
               wxMouseButton held = wxMOUSE_BTN_NONE) {
        wxMouseEvent event(type);
        event.SetPosition(place);
        event.SetLeftDown(held == wxMOUSE_BTN_LEFT);
        event.SetRightDown(held == wxMOUSE_BTN_RIGHT);
        stage_->canvas().GetEventHandler()->ProcessEvent(event);
    }
    void click(const wxPoint& place) {
        mouse(wxEVT_LEFT_DOWN, place, wxMOUSE_BTN_LEFT);
        mouse(wxEVT_LEFT_UP, place);
    }
    void drag(const wxPoint& from, const wxPoint& to, wxMouseButton button) {
        const bool left = button == wxMOUSE_BTN_LEFT;
        mouse(left ? wxEVT_LEFT_DOWN : wxEVT_RIGHT_DOWN, from, button);
        mouse(wxEVT_MOTION, to, button);
        mouse(left ? wxEVT_LEFT_UP : wxEVT_RIGHT_UP, to);
    }

    wxFrame* frame_;
    window::ScanStage* stage_;
    int shown_ = 0, picks_ = 0;
    std::optional<view::SegmentStory> picked_;
};

}  // namespace offmap::test
