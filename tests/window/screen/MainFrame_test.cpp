// SPDX-License-Identifier: BSD-3-Clause
#include "FrameFixture.h"

namespace offmap::window {

namespace {

using test::pumpUntil;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MainFrameTest : public test::FrameFixture {};

}  // namespace

TEST_F(MainFrameTest, emptyAtFirstItSaysWhatToDo) {
    const auto window = opened({}, {});
    EXPECT_TRUE(window->says("drop them here"));
    for (const Shortcut& shortcut : shortcuts()) {
        const bool asks = std::string_view(shortcut.key).starts_with("Ctrl+") ||
                          shortcut.action == Action::ShowShortcuts;
        if (!asks) window->frame().perform(shortcut.action);  // nothing to act upon
    }
    window->frame().perform(Action::ExportFigure);
    EXPECT_TRUE(window->says("no scan to export"));
    window->frame().perform(Action::Record);
    EXPECT_TRUE(window->says("nothing to record"));
}

TEST_F(MainFrameTest, aLogAndAMapCanBeDropped) {
    const auto window = opened({}, {});
    window->drop({log()});
    ASSERT_TRUE(window->showsTurn(0));
    EXPECT_TRUE(window->says("no map"));
    EXPECT_THAT(window->title(), HasSubstr("drive.rawlog"));
    window->frame().perform(Action::StepForward);
    ASSERT_TRUE(window->showsTurn(1));
    window->drop({map()});
    ASSERT_TRUE(pumpUntil([&] { return !window->stage().map().walls().empty(); }));
    EXPECT_TRUE(window->showsTurn(1)) << "where it was";
    EXPECT_EQ(window->message(), "");
}

TEST_F(MainFrameTest, aLogAndAMapThatAreDroppedTogetherBeginAtTheFirstTurn) {
    const auto window = opened(*folder_ / "other.rawlog", {});
    ASSERT_TRUE(window->showsTurn(0));
    window->frame().perform(Action::StepForward);
    ASSERT_TRUE(window->showsTurn(1));
    window->drop({log(), map()});
    ASSERT_TRUE(pumpUntil([&] { return !window->stage().map().walls().empty(); }));
    ASSERT_TRUE(window->showsAny());
    EXPECT_EQ(window->turn(), 0U) << "not where the log before stood";
}

TEST_F(MainFrameTest, aBadLogIsToldOfAndTheWindowWorksOn) {
    const auto window = opened(log(), {});
    ASSERT_TRUE(window->showsTurn(0));
    window->drop({*folder_ / "bad.rawlog"});
    EXPECT_TRUE(window->says("bad.rawlog"));
    EXPECT_FALSE(window->stage().shown());
    EXPECT_EQ(window->title(), "offmap-view");
    window->frame().perform(Action::StepForward);
    window->frame().perform(Action::ResetView);
    window->drop({map()});
    EXPECT_TRUE(pumpUntil([&] { return !window->stage().map().walls().empty(); }))
        << "the bad log does not stand in the way of " << window->message();
    window->drop({log()});
    EXPECT_TRUE(window->showsTurn(0));
}

TEST_F(MainFrameTest, aBadMapIsToldOfAndTheNextLogOpens) {
    const auto window = opened({}, *folder_ / "bad.txt");
    EXPECT_TRUE(window->says("bad.txt"));
    window->drop({log()});
    EXPECT_TRUE(window->showsTurn(0)) << window->message();
    window->drop({*folder_ / "bad.txt"});
    EXPECT_TRUE(window->says("bad.txt"));
    window->drop({map()});
    EXPECT_TRUE(window->showsTurn(0)) << window->message();
}

TEST_F(MainFrameTest, filesThatWereOpenAreRemembered) {
    {
        const auto window = opened(log(), map());
        ASSERT_TRUE(window->showsTurn(0));
        window->drop({*folder_ / "bad.rawlog"});
        ASSERT_TRUE(window->says("bad.rawlog"));
    }
    const auto window = opened({}, {});
    EXPECT_THAT(window->preferences().recentLogs(), ElementsAre(log().string()));
    EXPECT_THAT(window->preferences().recentMaps(), ElementsAre(map().string()));
}

TEST_F(MainFrameTest, filesThatAreGoneAreForgotten) {
    const auto gone = settings_ / "gone.rawlog";
    std::filesystem::copy(log(), gone);
    const auto window = opened(gone, {});
    ASSERT_TRUE(window->showsTurn(0));
    std::filesystem::remove(gone);
    window->drop({gone});
    EXPECT_TRUE(window->says("gone.rawlog"));
    EXPECT_THAT(window->preferences().recentLogs(), IsEmpty());
}

TEST_F(MainFrameTest, portsAreNoRecentFiles) {
    SessionRequest request = test::requestOf("udp:49613", map());
    request.live.shared.poses.fixed = "0,0,0";
    const auto window = opened(request);
    ASSERT_TRUE(pumpUntil([&] { return window->frame().session().playback() != nullptr; }));
    ASSERT_TRUE(pumpUntil([&] { return window->preferences().recentMaps().size() == 1; }));
    EXPECT_THAT(window->preferences().recentLogs(), IsEmpty());
}

TEST_F(MainFrameTest, playsAtTheSpeedThatItShows) {
    SessionRequest request = test::requestOf(log(), {});
    request.live.from.speed = "3";  // of the command line; the control had another one before
    const auto window = opened(request);
    ASSERT_TRUE(window->showsTurn(0));
    EXPECT_EQ(window->frame().workspace().controls->speed(), 3);
    window->frame().perform(Action::Faster);
    EXPECT_EQ(window->frame().workspace().controls->speed(), 5);
    window->drop({log()});
    ASSERT_TRUE(pumpUntil([&] { return window->title().find("x5") != std::string::npos; }))
        << window->title();
    EXPECT_EQ(window->frame().workspace().controls->speed(), 5);
}

TEST_F(MainFrameTest, keysReachTheirActionsButNotWhileOneTypes) {
    const auto window = opened(log(), {});
    ASSERT_TRUE(window->showsTurn(0));
    window->stage().canvas().SetFocus();
    EXPECT_TRUE(window->key(WXK_RIGHT));
    ASSERT_TRUE(window->showsTurn(1));
    EXPECT_TRUE(window->key('M'));
    EXPECT_FALSE(window->stage().choices().shown.mapped);
    EXPECT_FALSE(window->key('Z')) << "it means nothing";

    window->focusField();
    EXPECT_FALSE(window->key('M')) << "the field's";
    EXPECT_FALSE(window->key(WXK_SPACE));
    EXPECT_FALSE(window->key(WXK_LEFT));
    EXPECT_FALSE(window->stage().choices().shown.mapped);

    window->focusButton();
    EXPECT_FALSE(window->key(WXK_SPACE)) << "presses the button";
    EXPECT_TRUE(window->key('M'));
    EXPECT_TRUE(window->stage().choices().shown.mapped);
    EXPECT_FALSE(window->frame().session().playback()->playing());
}

TEST_F(MainFrameTest, menusDoWhatTheySay) {
    const auto window = opened(log(), {});
    ASSERT_TRUE(window->showsTurn(0));
    window->menu(MainMenu::idOf(Action::StepForward));
    EXPECT_TRUE(window->showsTurn(1));
    window->menu(MainMenu::idOf(Action::ShowWalls));
    EXPECT_FALSE(window->stage().choices().shown.walls);
    EXPECT_FALSE(MainMenu::actionOf(MainMenu::idOf(Action::ShowShortcuts) + 1));
    EXPECT_FALSE(MainMenu::actionOf(wxID_ABOUT));
}

TEST_F(MainFrameTest, aLogThatBecomesUnreadableIsToldOf) {
    const auto fragile = settings_ / "fragile.rawlog";
    std::filesystem::copy(log(), fragile);
    const auto window = opened(fragile, {});
    ASSERT_TRUE(window->showsTurn(0));
    window->frame().perform(Action::StepForward);
    ASSERT_TRUE(window->showsTurn(1));
    test::writeFile(fragile, "overwritten");
    window->frame().perform(Action::FirstTurn);
    EXPECT_TRUE(window->says("fragile.rawlog"));
}

TEST_F(MainFrameTest, aScreenshotIsWrittenWhereItWasStarted) {
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(settings_.path());
    const auto window = opened(log(), {});
    ASSERT_TRUE(window->showsTurn(0));
    window->frame().perform(Action::SaveScreenshot);
    std::filesystem::current_path(before);
    EXPECT_TRUE(window->says("wrote "));
    EXPECT_THAT(settings_.names(), testing::Contains(testing::EndsWith(".png")));
}

}  // namespace offmap::window
