// SPDX-License-Identifier: BSD-3-Clause
#include "FiguresPane.h"

#include "../MadeUpFrame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <wx/frame.h>

namespace offmap::window {

namespace {

using testing::Contains;

class FiguresPaneTest : public testing::Test {
 protected:
    FiguresPaneTest() {
        auto frame = std::make_shared<live::LiveFrame>(test::madeUpFrame());
        frame->reduced.record.counts.returns = 1000;
        frame->reduced.record.removedByRay = 250;
        frame->reduced.record.health.suspect = core::Suspicion::Biased;
        turn_ = frame;
    }
    ~FiguresPaneTest() override { delete frame_; }

    std::multiset<std::string> texts() const {
        std::multiset<std::string> texts;
        for (const wxWindow* child : figures_->GetChildren()) {
            texts.insert(child->GetLabel().utf8_string());
        }
        return texts;
    }

    wxFrame* frame_ = new wxFrame(nullptr, wxID_ANY, "figures");
    FiguresPane* figures_ = new FiguresPane(frame_);
    live::LiveFramePtr turn_;
};

}  // namespace

TEST_F(FiguresPaneTest, showsTheFiguresOfTheTurn) {
    figures_->show({}, turn_);
    EXPECT_THAT(texts(), Contains("1,000"));
    EXPECT_THAT(texts(), Contains("250 (25.0 %)"));
}

TEST_F(FiguresPaneTest, aSuspectTurnStandsOutInBothThemes) {
    const std::string words = "suspect: all walls nearer or further than mapped";
    for (const Theme* theme : {&Theme::darkOne(), &Theme::lightOne()}) {
        figures_->show({}, turn_);
        figures_->setTheme(*theme);
        for (const wxWindow* child : figures_->GetChildren()) {
            if (child->GetLabel().utf8_string() != words) continue;
            EXPECT_EQ(child->GetForegroundColour(), theme->bad);
            EXPECT_EQ(child->GetToolTipText().utf8_string(), words) << "it may be cut short";
        }
    }
    EXPECT_THAT(texts(), Contains(words));
}

TEST_F(FiguresPaneTest, clearForgetsTheTurn) {
    const auto before = texts();
    figures_->show({}, turn_);
    EXPECT_NE(texts(), before);
    figures_->clear();
    EXPECT_EQ(texts(), before);
}

}  // namespace offmap::window
