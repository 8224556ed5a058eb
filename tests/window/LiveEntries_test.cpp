// SPDX-License-Identifier: BSD-3-Clause
#include "LiveEntries.h"

#include "../support/TemporaryFolder.h"
#include "input/UsageError.h"

#include <gmock/gmock.h>

namespace offmap::window {

namespace {

/// What the user is told; empty if nothing is wrong.
std::string complaintAbout(const LiveEntries& entries) {
    try {
        liveChoiceOf(entries);
        return {};
    } catch (const app::UsageError& error) {
        return error.what();
    }
}

}  // namespace

TEST(LiveEntries, aVelodyneOnTheNetworkIsTrackedFromThePose) {
    LiveEntries entries;
    entries.port = " 2369 ";
    entries.x = "1.5 ";
    entries.yaw = "-90";
    const LiveChoice choice = liveChoiceOf(entries);
    EXPECT_EQ(choice.from.udpPort(), 2369);
    EXPECT_EQ(choice.from.track, "1.5,0,-90");
    EXPECT_EQ(choice.poses.fixed, "");
    EXPECT_FALSE(choice.from.follow);
}

TEST(LiveEntries, aRobotThatStandsHasAFixedPose) {
    LiveEntries entries;
    entries.poses = LivePoseKind::Fixed;
    entries.y = "2";
    const LiveChoice choice = liveChoiceOf(entries);
    EXPECT_EQ(choice.from.track, "");
    const auto pose = choice.poses.request().fixed;
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->y, 2);
}

TEST(LiveEntries, aGrowingLogIsFollowedWithItsOwnPoses) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "run.rawlog", "");
    LiveEntries entries;
    entries.kind = LiveKind::GrowingLog;
    entries.file = folder / "run.rawlog";
    entries.poses = LivePoseKind::FromSource;
    const LiveChoice choice = liveChoiceOf(entries);
    EXPECT_TRUE(choice.from.follow);
    EXPECT_EQ(choice.from.source, entries.file);
    EXPECT_TRUE(choice.from.track.empty() && choice.poses.fixed.empty());
}

TEST(LiveEntries, whatIsWrongIsNamed) {
    LiveEntries entries;
    entries.port = "70000";
    EXPECT_THAT(complaintAbout(entries), testing::HasSubstr("1 ... 65535"));
    entries.port = "";
    EXPECT_THAT(complaintAbout(entries), testing::HasSubstr("1 ... 65535"));
    entries = {};
    entries.y = "1,5";
    EXPECT_EQ(complaintAbout(entries), "y is '1,5', but must be 1 number, in metres");
    entries = {};
    entries.yaw = "";
    EXPECT_THAT(complaintAbout(entries), testing::HasSubstr("yaw"));
    entries = {};
    entries.label = " ";
    EXPECT_THAT(complaintAbout(entries), testing::HasSubstr("label"));
    entries = {};
    entries.poses = LivePoseKind::FromSource;
    EXPECT_THAT(complaintAbout(entries), testing::HasSubstr("no poses"));
}

TEST(LiveEntries, aFileHasToBeThereAndOfTheKindThatWasChosen) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.pcap", "a.ini", "a.rawlog"}) test::writeFile(folder / name, "");
    const auto complaint = [&](LiveKind kind, const std::string& name) {
        LiveEntries entries;
        entries.kind = kind;
        entries.file = name.empty() ? "" : (folder / name).string();
        return complaintAbout(entries);
    };
    EXPECT_EQ(complaint(LiveKind::Capture, "a.pcap"), "");
    EXPECT_EQ(complaint(LiveKind::Sensors, "a.ini"), "");
    EXPECT_EQ(complaint(LiveKind::GrowingLog, "a.rawlog"), "");
    EXPECT_THAT(complaint(LiveKind::Capture, "a.ini"), testing::HasSubstr(".pcap"));
    EXPECT_THAT(complaint(LiveKind::Sensors, "a.rawlog"), testing::HasSubstr(".ini"));
    EXPECT_THAT(complaint(LiveKind::GrowingLog, "a.pcap"), testing::HasSubstr("not a rawlog"));
    EXPECT_THAT(complaint(LiveKind::Capture, "b.pcap"), testing::HasSubstr("not there"));
    EXPECT_THAT(complaint(LiveKind::Capture, "."), testing::HasSubstr("not a file"));
    EXPECT_THAT(complaint(LiveKind::Capture, ""), testing::HasSubstr("no file"));
}

}  // namespace offmap::window
