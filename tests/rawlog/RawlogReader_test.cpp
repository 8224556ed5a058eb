// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ForkedChild.h"
#include "ReadLogFixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace offmap::rawlog;
using offmap::test::gunzippedFile;
using offmap::test::gzipped;
using offmap::test::TemporaryFolder;
using offmap::test::writeFile;
using testing::AllOf;
using testing::HasSubstr;

TEST(RawlogReader, entriesAreTheBytesOfTheStream) {
    const std::pair<const char*, size_t> logs[] = {
        {"localization_demo.rawlog", 74},
        {"2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog", 449},
        {"test_velodyne_VLP16.rawlog", 1}};
    for (const auto& [name, entries] : logs) {
        const ReadLog log = readAll(datasets / name);
        EXPECT_EQ(log.error, "") << name;
        EXPECT_EQ(log.offsets.size(), entries) << name;
        EXPECT_EQ(log.bytes, gunzippedFile(datasets / name)) << name;
    }
}

TEST_F(RawlogReaderOnFile, plainLogCutAnywhereSaysWhere) {
    const std::string log = smallLog();
    const std::vector<uint64_t> begins = readContent(log).offsets;
    ASSERT_EQ(begins.size(), 3U);
    for (size_t size = 1; size < log.size(); ++size) {
        const ReadLog cut = readContent(log.substr(0, size));
        const bool betweenEntries = std::ranges::count(begins, size) > 0;
        EXPECT_EQ(cut.error.empty(), betweenEntries) << size;
        const auto complete = std::ranges::count_if(begins, [&](auto b) { return b <= size; }) - 1;
        if (betweenEntries) continue;
        EXPECT_EQ(cut.errorPlace.index, static_cast<size_t>(complete)) << size;
        EXPECT_EQ(cut.errorPlace.offset, begins[static_cast<size_t>(complete)]) << size;
        if (size < 5) continue;  // too short to be known as a rawlog
        EXPECT_THAT(cut.error, HasSubstr("the file ends inside it")) << size;
    }
}

TEST_F(RawlogReaderOnFile, unknownClassIsNamed) {
    const std::string log = smallLog();
    std::string content = log + log;
    content.replace(content.find("Odometry", log.size()), 8, "Odometri");
    const ReadLog read = readContent(content);
    EXPECT_EQ(read.errorPlace.index, 4U);
    EXPECT_THAT(read.error,
                AllOf(HasSubstr("x.rawlog: entry 4 at byte "), HasSubstr("CObservationOdometri"),
                      HasSubstr("the file is truncated or corrupt")));
    EXPECT_THAT(read.error, Not(AnyOf(HasSubstr("\n"), HasSubstr(".cpp"), HasSubstr("MRPT"))));
}

TEST_F(RawlogReaderOnFile, garbageInTheMiddleSaysWhere) {
    const std::string log = smallLog();
    const ReadLog read = readContent(log + "this is no object" + log);
    EXPECT_EQ(read.errorPlace, (EntryPlace{3, log.size()}));
    EXPECT_EQ(read.bytes, log);
}

TEST_F(RawlogReaderOnFile, emptyFilesAreCalledEmpty) {
    for (const std::string& content : {std::string(), gzipped("")}) {
        EXPECT_THAT(readContent(content).error, HasSubstr("x.rawlog is empty"));
    }
}

TEST_F(RawlogReaderOnFile, otherFilesAreNotRawlogs) {
    for (const std::string& content : {std::string("0 0 4 0\n4 0 4 3\n"), std::string("a"),
                                       gzipped("some text"), std::string(4096, '\0')}) {
        EXPECT_THAT(readContent(content).error, HasSubstr("x.rawlog is not a rawlog"));
    }
    EXPECT_THAT(readAll(datasets / "2006-MalagaCampus.gridmap.gz").error,
                AllOf(HasSubstr("is not a rawlog"), HasSubstr("COccupancyGridMap2D")));
}

TEST(RawlogReader, whatCannotBeOpenedNamesTheCause) {
    const TemporaryFolder folder;
    EXPECT_THAT(readAll(folder / "no.rawlog").error,
                AllOf(HasSubstr("no.rawlog: No such file"), HasSubstr("check the path")));
    EXPECT_THAT(readAll(folder.path()).error, HasSubstr("is a folder"));
    EXPECT_THAT(readAll("/dev/null").error, HasSubstr("is not a regular file"));
}

TEST(RawlogReader, fileWithoutPermissionNamesTheCause) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
    writeFile(folder / "x.rawlog", smallLog());
    std::filesystem::permissions(folder / "x.rawlog", std::filesystem::perms{0});
    const std::string error = offmap::test::inForkedChild([&] {
        offmap::test::dropRoot();
        return readAll(folder / "x.rawlog").error;
    });
    EXPECT_THAT(error, AllOf(HasSubstr("Permission denied"), HasSubstr("check its permissions")));
}

}  // namespace
