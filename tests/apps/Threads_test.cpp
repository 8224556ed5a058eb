// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/Scans.h"
#include "RawlogEdit.h"
#include "ReduceFixture.h"

#include <mrpt/obs/CRawlog.h>

namespace {

using namespace offmap::test;
using testing::HasSubstr;

/// What one run writes, by file.
struct Outputs {
    std::string reduced, removed, segments, pictures;
    friend bool operator==(const Outputs&, const Outputs&) = default;
};

class Threads : public ReduceFixture {
 protected:
    Outputs outputsOf(const Arguments& more) const {
        const auto removed = folder_ / "removed.rawlog", segments = folder_ / "segments.csv",
                   pictures = folder_ / "pictures.rawlog";
        Arguments all{"--removed", removed,   "--segments",    segments, "--inspect",
                      pictures,    "--force", "--write-poses", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        const RunResult run = reduce(all);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return {readFile(out_), readFile(removed), readFile(segments), readFile(pictures)};
    }

    void expectSameBytesInAnyNumber() const {
        const Outputs alone = outputsOf({"--threads", "1"});
        EXPECT_GT(gunzippedFile(out_).size(), size_t{1} << 20) << "too short to be cut into blocks";
        for (const char* threads : {"2", "3", "7"}) {
            EXPECT_TRUE(alone == outputsOf({"--threads", threads})) << threads << " threads";
        }
        EXPECT_TRUE(alone == outputsOf({})) << "as many as there are processors";
    }

    SimulatedRobot robot_;
};

TEST_F(Threads, giveTheSameBytesOfSeveralSensors) {
    writeLog(in_, secondsOf(robot_, 12));
    expectSameBytesInAnyNumber();
}

TEST_F(Threads, giveTheSameBytesOfFrames) {
    writeLog(in_, inFrames(secondsOf(robot_, 12)));
    expectSameBytesInAnyNumber();
}

TEST_F(Threads, giveBlocksThatMrptReadsAsOneLog) {
    writeLog(in_, secondsOf(robot_, 6));
    const Path removed = folder_ / "removed.rawlog";
    mrpt::obs::CRawlog before;  // as RawLogViewer reads it
    ASSERT_TRUE(before.loadFromRawLogFile(in_.string()));
    ASSERT_EQ(reduce({"--threads", "3", "--removed", removed}).exitCode, 0);
    for (const Path& file : {out_, removed}) {
        const std::string content = gunzippedFile(file);
        ASSERT_GT(content.size(), size_t{1} << 20) << "too short to be cut into blocks";
        expectRawlogEditReads(file, in_);
        mrpt::obs::CRawlog after;
        ASSERT_TRUE(after.loadFromRawLogFile(file.string()));
        EXPECT_EQ(after.size(), before.size());
    }
}

TEST_F(Threads, givePlacesOfDamageAllTheSame) {
    writeLog(in_, secondsOf(robot_, 3), std::nullopt);
    const std::string log = readFile(in_);
    writeFile(in_, log.substr(0, log.size() - 1));
    const std::string last = std::to_string(secondsOf(robot_, 3).size() - 1);
    for (const char* threads : {"1", "3"}) {
        expectRefusal(reduceArguments({"--threads", threads}), 2,
                      HasSubstr("entry " + last + " at byte"));
        const RunResult run = reduce({"--threads", threads, "--keep-going", "--force"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(std::to_string(entriesOf(out_).size()), last);
        std::filesystem::remove(out_);
    }
}

TEST_F(Threads, mustBeAtLeastOne) {
    writeLog(in_, smallLog());
    expectRefusal(reduceArguments({"--threads", "0"}), 1, HasSubstr("--threads"));
}

class Compression : public Threads {};

TEST_F(Compression, changesNoUncompressedByte) {
    writeLog(in_, secondsOf(robot_, 4));
    const Outputs usual = outputsOf({});
    EXPECT_TRUE(usual == outputsOf({"--compression", "1"}));
    const std::string reduced = gunzippedFile(out_),
                      removed = gunzippedFile(folder_ / "removed.rawlog");
    const Outputs stored = outputsOf({"--compression", "0"});
    EXPECT_TRUE(gunzippedFile(out_) == reduced);
    EXPECT_TRUE(gunzippedFile(folder_ / "removed.rawlog") == removed);
    EXPECT_GT(stored.reduced.size(), reduced.size()) << "as it is, and the frame of gzip";
    const Outputs smallest = outputsOf({"--compression", "9"});
    EXPECT_TRUE(gunzippedFile(out_) == reduced);
    EXPECT_LT(smallest.reduced.size(), usual.reduced.size());
}

TEST_F(Compression, hasTenLevels) {
    writeLog(in_, smallLog());
    expectRefusal(reduceArguments({"--compression", "10"}), 1, HasSubstr("--compression"));
}

}  // namespace
