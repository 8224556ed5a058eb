// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOptions.h"

#include "input/UsageError.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace offmap::window {

namespace {

ViewOptions parsed(std::vector<std::string> words) {
    ViewOptions options;
    CLI::App command;
    options.addTo(command);
    std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
    command.parse(std::move(words));
    return options;
}

}  // namespace

TEST(ViewOptions, nothingNeedBeGiven) {
    const auto request = parsed({}).request();
    EXPECT_EQ(request.from.source, "");
    EXPECT_EQ(request.shared.map, "");
    EXPECT_TRUE(request.forWindow);
}

TEST(ViewOptions, aLogAndHowItIsPlayed) {
    const ViewOptions options = parsed({"a.rawlog", "--map", "b.dxf", "--play", "--speed", "5"});
    EXPECT_TRUE(options.play);
    EXPECT_EQ(options.request().from.source, "a.rawlog");
    EXPECT_EQ(options.request().from.speedFactor(), 5);
    EXPECT_EQ(options.request().shared.map, "b.dxf");
}

TEST(ViewOptions, aLiveSourceInsteadOfALog) {
    EXPECT_EQ(parsed({"--live", "udp:2369"}).request().from.udpPort(), 2369);
    EXPECT_THROW(parsed({"a.rawlog", "--live", "udp"}).request(), app::UsageError);
}

TEST(ViewOptions, whatCannotBeMeantIsRefusedBeforeTheWindowOpens) {
    EXPECT_THROW(parsed({"a.rawlog", "--speed", "quick"}).request(), app::UsageError);
    EXPECT_THROW(parsed({"--speed", "0"}).request(), app::UsageError);
    EXPECT_THROW(parsed({"--live", "udp:99999"}).request(), app::UsageError);
    EXPECT_THROW(parsed({"a.rawlog", "--map", "m.txt", "--map-scale", "0"}).request(),
                 app::UsageError);
}

}  // namespace offmap::window
