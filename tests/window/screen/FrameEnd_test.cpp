// SPDX-License-Identifier: BSD-3-Clause
#include "../EndlessFile.h"
#include "DrawnPicture.h"
#include "FrameFixture.h"

#include <csignal>
#include <wx/msgdlg.h>

namespace offmap::window {

namespace {

using test::pumpUntil;

constexpr std::chrono::seconds twoSeconds{2};

class FrameEndTest : public test::FrameFixture {};

}  // namespace

TEST_F(FrameEndTest, looksAsItDidWhenItWasClosed) {
    wxSize size;
    {
        const auto window = opened(log(), {});
        ASSERT_TRUE(window->showsTurn(0));
        for (const Action action : {Action::SwitchTheme, Action::ColourByHeight, Action::TopCamera,
                                    Action::ShowWalls, Action::LargerPoints, Action::Faster}) {
            window->frame().perform(action);
        }
        window->frame().SetSize(900, 640);
        wxYield();
        size = window->frame().GetSize();
    }
    const auto window = opened({}, {});
    EXPECT_EQ(window->stage().cameraMode(), CameraMode::Top);
    const SceneChoices& choices = window->stage().choices();
    EXPECT_EQ(choices.colourBy, view::ColourBy::Height);
    EXPECT_FALSE(choices.shown.walls);
    EXPECT_TRUE(choices.shown.mapped);
    EXPECT_EQ(choices.pointSize, SceneChoices().pointSize + 0.5);
    EXPECT_EQ(window->frame().GetSize(), size);
    wxImage picture;
    ASSERT_TRUE(pumpUntil([&] { return (picture = window->stage().canvas().picture()).IsOk(); }));
    EXPECT_TRUE(test::hasColour(picture, 3, 3, toWx(Theme::lightOne().palette.background)));
}

TEST_F(FrameEndTest, closesWhileItLoads) {
    test::EndlessFile endless(settings_ / "endless.rawlog");
    const auto window = opened(endless.path(), {});
    ASSERT_TRUE(endless.isRead());
    EXPECT_TRUE(window->frame().session().opening());
    EXPECT_LT(window->timeToClose(), twoSeconds);
}

TEST_F(FrameEndTest, closesWhileItPlaysAsFastAsItCan) {
    const auto longLog = settings_ / "long.rawlog";
    test::writeLog(longLog, test::officeDrive(200));
    SessionRequest request = test::requestOf(longLog, {});
    request.play = true;
    const auto window = opened(request);
    ASSERT_TRUE(window->showsAny());
    EXPECT_LT(window->timeToClose(), twoSeconds);
}

TEST_F(FrameEndTest, aSignalEndsItThroughDialogs) {
    // One of each kind: the toolkit's, the desktop's, and one that the desktop runs by itself.
    const std::vector<std::function<void(MainFrame&)>> asking{
        [](MainFrame& frame) { frame.perform(Action::ShowShortcuts); },
        [](MainFrame& frame) { frame.perform(Action::OpenLog); },
        [](MainFrame& frame) { wxMessageDialog(&frame, "Well?").ShowModal(); }};
    for (const auto& ask : asking) {
        const auto window = opened({}, {});
        window->frame().CallAfter([] { raise(SIGTERM); });
        ask(window->frame());  // returns when the dialog ends
        EXPECT_TRUE(pumpUntil([&] { return !window->isOpen(); }, twoSeconds));
    }
}

TEST_F(FrameEndTest, aRecordingIsFinishedBeforeAnotherLogOpensAndAtTheEnd) {
    const auto first = settings_ / "first.rawlog", second = settings_ / "second.rawlog";
    const auto window = opened(log(), {});
    ASSERT_TRUE(window->showsTurn(0));
    window->frame().session().playback()->record(first);
    window->frame().perform(Action::StepForward);
    ASSERT_TRUE(window->showsTurn(1));
    window->drop({*folder_ / "other.rawlog"});
    EXPECT_EQ(test::scanTimes(test::observationsOf(first)).size(), 1U);
    ASSERT_TRUE(pumpUntil([&] { return window->title().find("other") != std::string::npos; }));
    ASSERT_TRUE(window->showsTurn(0));
    window->frame().session().playback()->record(second);
    EXPECT_LT(window->timeToClose(), twoSeconds);
    EXPECT_TRUE(std::filesystem::exists(second));
}

}  // namespace offmap::window
