// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "CraftedEntries.h"
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadLog : public ReduceFixture {
 protected:
    /// Reduction of a log of this content must fail and say why.
    template <class Matcher>
    void expectRefused(const std::string& content, const Matcher& message) {
        writeFile(in_, content);
        expectRefusal(reduceArguments(), 2, AllOf(HasSubstr(in_.string()), message));
    }

    std::string plainSmallLog() {
        writeLog(in_, smallLog(), std::nullopt);
        return readFile(in_);
    }
};

TEST_F(BadLog, missingFileIsNamed) {
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("cannot open " + in_.string()), HasSubstr("check the path")));
}

TEST_F(BadLog, folderIsNamed) {
    in_ = folder_.path();
    expectRefusal(reduceArguments(), 2, HasSubstr("is a folder; name a file in it"));
}

TEST_F(BadLog, emptyFileIsRefused) {
    expectRefused("", HasSubstr("is empty: it holds no entry; check how it was recorded"));
}

TEST_F(BadLog, emptyGzipFileIsRefused) {
    expectRefused(gzipped(""), HasSubstr("is empty: it holds no entry; check how it was recorded"));
}

TEST_F(BadLog, textIsNoRawlog) {
    expectRefused("x y z\n1.0 2.0 3.0\n", HasSubstr("is not a rawlog"));
}

TEST_F(BadLog, pictureIsNoRawlog) {
    expectRefused(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), HasSubstr("is not a rawlog"));
}

TEST_F(BadLog, truncatedPlainLogTellsEntryAndByte) {
    const std::string whole = plainSmallLog();
    size_t begin = 0, index = 0;
    for (const LogEntry& entry : entriesOf(in_)) {
        const std::string place =
            "entry " + std::to_string(index) + " at byte " +
            (begin < 1000 ? std::to_string(begin)
                          : std::to_string(begin / 1000) + "," +
                                std::to_string(1000 + begin % 1000).substr(1));
        for (const size_t cut : {size_t{1}, entry.bytes.size() / 2, entry.bytes.size() - 1}) {
            if (index == 0 && cut == 1) continue;  // one byte does not look like a log
            SCOPED_TRACE(place + " cut after " + std::to_string(cut));
            expectRefused(whole.substr(0, begin + cut),
                          AllOf(HasSubstr(place + " "), HasSubstr("truncated"),
                                HasSubstr(index == 0 ? "" : "--keep-going")));
        }
        begin += entry.bytes.size();
        ++index;
    }
    EXPECT_EQ(index, 3U);
}

TEST_F(BadLog, truncatedGzipLogIsRefused) {
    const std::string packed = gzipped(plainSmallLog());
    for (const double share : {0.01, 0.3, 0.6, 0.9, 0.999}) {
        SCOPED_TRACE(share);
        expectRefused(
            packed.substr(0, static_cast<size_t>(share * static_cast<double>(packed.size()))),
            AllOf(HasSubstr("entry "), HasSubstr("truncated"), HasSubstr("--keep-going")));
    }
}

TEST_F(BadLog, flippedByteInGzipIsRefused) {
    const std::string packed = gzipped(plainSmallLog());
    for (const double share : {0.1, 0.4, 0.7, 0.95}) {
        SCOPED_TRACE(share);
        std::string damaged = packed;
        char& byte = damaged[static_cast<size_t>(share * static_cast<double>(packed.size()))];
        byte = static_cast<char>(byte ^ 0x55);
        expectRefused(damaged, HasSubstr("--keep-going"));
    }
}

TEST_F(BadLog, flippedByteInPlainLogIsSurvived) {
    const std::string whole = plainSmallLog();
    std::mt19937 random(7);
    int refused = 0;
    for (int trial = 0; trial < 30; ++trial) {
        // Half of them where the structure is densest.
        const size_t range = trial % 2 == 0 ? whole.size() : 120;
        refused += !reducesOrRefuses(withByteFlipped(whole, range, random));
    }
    EXPECT_GT(refused, 0);
}

TEST_F(BadLog, hugeLengthIsRefused) {
    expectRefused(plainSmallLog() + scanOfHugeLength(),
                  AllOf(HasSubstr("entry 3 "), HasSubstr("--keep-going")));
}

TEST_F(BadLog, deeplyNestedFramesAreRefused) {
    expectRefused(plainSmallLog() + framesNested(20'000),
                  AllOf(HasSubstr("entry 3 "), HasSubstr("crashed"), HasSubstr("--keep-going")));
}

TEST_F(BadLog, wrongClassAmongActionsIsRefused) {
    expectRefused(plainSmallLog() + actionsHoldingAComment(),
                  AllOf(HasSubstr("entry 3 "), HasSubstr("--keep-going")));
}

TEST_F(BadLog, logWithout3dScanTellsWhatItHolds) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.localisation(), robot.horizontalScan(), robot.odometry()});
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr(in_.string() + " holds no 3D scan"),
                        HasSubstr("FRONT_LASER (1 x CObservation2DRangeScan)"),
                        HasSubstr("ODOMETRY (1 x CObservationOdometry)"),
                        HasSubstr("--keep-going copies the log")));
}

TEST_F(BadLog, sensorsWithoutLabelAreToldToo) {
    in_ = "/usr/share/mrpt/datasets/localization_demo.rawlog";
    expectRefusal(reduceArguments(), 2, HasSubstr("no label (37 x CObservation2DRangeScan)"));
}

TEST_F(BadLog, withoutScansOfColumnsTellsWhatItHolds) {
    in_ = "/usr/share/mrpt/datasets/localization_demo.rawlog";
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("holds no 3D scan that could be reduced"),
                        HasSubstr("CObservation2DRangeScan")));
}

TEST_F(BadLog, unreadableFileIsRefused) {
    writeLog(in_, smallLog());
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0777));
    std::filesystem::permissions(in_, std::filesystem::perms(0));
    const RunResult run = reduce({}, {.user = unprivileged()});
    EXPECT_EQ(run.exitCode, 2) << testing::PrintToString(run);
    EXPECT_THAT(run.err, AllOf(HasSubstr("cannot open " + in_.string()),
                               HasSubstr("check its permissions")));
    EXPECT_THAT(folder_.names(), testing::UnorderedElementsAre("in.rawlog", "office.lines"));
}

}  // namespace
