// SPDX-License-Identifier: BSD-3-Clause
#include "ReadLogFixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace offmap::rawlog;
using offmap::test::gunzippedFile;
using offmap::test::gzipped;
using testing::AllOf;
using testing::HasSubstr;

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

TEST_F(RawlogReaderOnFile, garbageAfterGzipIsNoticed) {
    const std::string log = smallLog();
    const ReadLog read = readContent(gzipped(log) + log);
    EXPECT_THAT(read.error, HasSubstr("bytes that are not gzip follow"));
    EXPECT_EQ(read.bytes, log);
}

}  // namespace
