// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ForkedChild.h"
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>

namespace {

using namespace offmap::rawlog;
using offmap::test::gunzippedFile;
using offmap::test::gzipped;
using offmap::test::TemporaryFolder;
using offmap::test::writeFile;
using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path datasets = "/usr/share/mrpt/datasets";

struct ReadLog {
    std::string bytes;              ///< of all entries
    std::vector<uint64_t> offsets;  ///< of each entry
    std::string error;
    EntryPlace errorPlace;
    friend bool operator==(const ReadLog&, const ReadLog&) = default;
};

ReadLog readAll(const std::filesystem::path& file, Reading reading) {
    ReadLog log;
    try {
        RawlogReader reader(file, {}, reading);
        while (const auto entry = reader.next()) {
            EXPECT_EQ(entry->place, (EntryPlace{log.offsets.size(), log.bytes.size()}));
            log.offsets.push_back(entry->place.offset);
            log.bytes.append(reinterpret_cast<const char*>(entry->bytes.data()),
                             entry->bytes.size());
        }
        EXPECT_EQ(reader.compressedPosition(), reader.compressedSize());
    } catch (const RawlogError& e) {
        log.error = e.what();
        log.errorPlace = e.place;
    }
    return log;
}

/// It makes no difference who reads the file.
ReadLog readAll(const std::filesystem::path& file) {
    ReadLog log = readAll(file, Reading{});
    EXPECT_TRUE(log == readAll(file, Reading{.ahead = true}));
    return log;
}

// Three small entries: every place where it can break is tried.
std::string smallLog() {
    const TemporaryFolder folder;
    RawlogWriter writer(folder / "small.rawlog");
    mrpt::obs::CObservationComment comment;
    comment.text = "recorded by hand";
    mrpt::obs::CObservationOdometry odometry;
    odometry.sensorLabel = "ODOMETRY";
    writer.write(comment);
    writer.write(odometry);
    writer.write(comment);
    writer.publish();
    return gunzippedFile(writer.target());
}

class RawlogReaderOnFile : public testing::Test {
 protected:
    ReadLog readContent(const std::string& content) {
        writeFile(file_, content);
        return readAll(file_);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "x.rawlog";
};

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

TEST_F(RawlogReaderOnFile, plainAndGzipAndSeveralMembersReadAlike) {
    const std::string log = smallLog();
    for (const std::string& content :
         {log + log, gzipped(log + log), gzipped(log) + gzipped(log),
          gzipped(log) + std::string(3000, '\0') + gzipped(log) + std::string(5, '\0')}) {
        const ReadLog read = readContent(content);
        EXPECT_EQ(read.error, "");
        EXPECT_EQ(read.bytes, log + log);
        EXPECT_EQ(read.offsets.size(), 6U);
    }
}

TEST_F(RawlogReaderOnFile, membersOfAnySizeReadAlike) {
    std::string log;
    while (log.size() < 300'000) log += smallLog();
    for (const size_t size : {1'000, 10'001, 299'999}) {
        SCOPED_TRACE(size);
        std::string packed = gzipped("");
        size_t middle = 0;  // where a member begins
        for (size_t i = 0; i < log.size(); i += size) {
            if (i < log.size() / 2) middle = packed.size();
            packed += gzipped(log.substr(i, size));
        }
        packed += gzipped("");
        EXPECT_EQ(readContent(packed).bytes, log);
        const ReadLog cut = readContent(packed.substr(0, packed.size() - 25));
        EXPECT_EQ(cut.bytes, log.substr(0, cut.bytes.size()));
        constexpr size_t timeStamp = 4, content = 20;  // [byte] of the member
        packed[middle + timeStamp] ^= 0x01;            // looks like no other's, and is sound
        EXPECT_EQ(readContent(packed).bytes, log);
        packed[middle + content] ^= 0x01;
        EXPECT_NE(readContent(packed).error, "");
    }
}

TEST_F(RawlogReaderOnFile, whatLooksLikeAMemberInsideAnotherIsNone) {
    mrpt::obs::CObservationComment comment;
    comment.text = gzipped("a log in a log");
    for (const int comments : {10, 30'000}) {  // up to 3 MB
        RawlogWriter writer(folder_ / "nested.rawlog", {.gzipLevel = {}, .overwrite = true});
        for (int i = 0; i < comments; ++i) writer.write(comment);
        writer.publish();
        const std::string log = gunzippedFile(writer.target()), stored = gzipped(log, 0);
        const std::string packed = gzipped(log);
        ASSERT_EQ(packed.substr(0, 10), comment.text.substr(0, 10));
        EXPECT_EQ(readContent(packed + stored + packed).bytes, log + log + log);
        EXPECT_EQ(readContent(stored + stored).bytes, log + log);
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

TEST_F(RawlogReaderOnFile, gzipLogCutAnywhereIsNoticed) {
    const std::string log = smallLog();
    const std::string packed = gzipped(log);
    for (size_t size = 2; size < packed.size(); ++size) {
        const ReadLog cut = readContent(packed.substr(0, size));
        EXPECT_THAT(cut.error, HasSubstr("its gzip stream ends too early")) << size;
        EXPECT_EQ(cut.bytes, log.substr(0, cut.errorPlace.offset)) << size;
    }
    // Only the trailer is missing: all entries are there, yet the file is not complete.
    EXPECT_EQ(readContent(packed.substr(0, packed.size() - 8)).errorPlace,
              (EntryPlace{3, log.size()}));
}

TEST_F(RawlogReaderOnFile, wrongChecksumIsNoticed) {
    const std::string log = smallLog();
    for (size_t fromEnd = 1; fromEnd <= 8; ++fromEnd) {
        std::string packed = gzipped(log);
        packed[packed.size() - fromEnd] ^= 0x10;
        const ReadLog read = readContent(packed);
        EXPECT_THAT(read.error, AllOf(HasSubstr("entry 3"), HasSubstr("gzip: incorrect")));
        EXPECT_EQ(read.bytes, log);
    }
}

TEST_F(RawlogReaderOnFile, flippedByteInGzipIsNoticed) {
    std::string packed = offmap::test::readFile(datasets / "localization_demo.rawlog");
    packed[packed.size() / 2] ^= 0x01;
    const ReadLog read = readContent(packed);
    EXPECT_THAT(read.error, HasSubstr("x.rawlog: entry "));
    // What came before the flipped byte is right; its half is on the safe side.
    const std::string original = gunzippedFile(datasets / "localization_demo.rawlog");
    EXPECT_THAT(original, testing::StartsWith(read.bytes.substr(0, original.size() / 4)));
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

TEST_F(RawlogReaderOnFile, garbageAfterGzipIsNoticed) {
    const std::string log = smallLog();
    const ReadLog read = readContent(gzipped(log) + log);
    EXPECT_THAT(read.error, HasSubstr("bytes that are not gzip follow"));
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
