// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "CraftedEntries.h"
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class KeepGoing : public ReduceFixture {
 protected:
    /// Two seconds of a log, followed by bytes that cannot be read.
    void writeLogThatEndsIn(const std::string& bytes) {
        writeLog(in_, secondsOf(robot_, 2), std::nullopt);
        whole_ = entriesOf(in_);
        writeFile(in_, readFile(in_) + bytes);
    }

    /// All of the readable entries are in the output, which is what the undamaged log yields.
    void expectReadableEntriesWritten() {
        expectRefusal(reduceArguments(), 2, HasSubstr("--keep-going"));
        const auto report = folder_ / "report.json";
        const RunResult run = reduce({"--keep-going", "--report", report});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const std::string count = std::to_string(whole_.size());
        EXPECT_THAT(run.err, AllOf(HasSubstr("warning: only the first " + count + " entries"),
                                   HasSubstr("entry " + count + " at byte")));
        const auto json = nlohmann::json::parse(readFile(report));
        EXPECT_EQ(json["entries"], whole_.size());
        EXPECT_THAT(json["warnings"].dump(), HasSubstr("only the first " + count));
        const std::string ofDamaged = readFile(out_);

        Objects objects;
        for (const LogEntry& entry : whole_) objects.push_back(entry.object);
        writeLog(in_, objects);
        EXPECT_EQ(reduce({"--force"}).exitCode, 0);
        EXPECT_TRUE(ofDamaged == readFile(out_));
    }

    SimulatedRobot robot_;
    std::vector<LogEntry> whole_;
};

TEST_F(KeepGoing, truncatedLogIsReducedToItsEnd) {
    const std::string scan = bytesOf(*robot_.vlp16());
    writeLogThatEndsIn(scan.substr(0, scan.size() / 2));
    expectReadableEntriesWritten();
}

TEST_F(KeepGoing, unknownClassEndsTheLog) {
    writeLogThatEndsIn(
        "\x89"
        "CUnheardOf" +
        std::string(100, '\0'));
    expectReadableEntriesWritten();
}

// MRPT's deserialiser dies of this one.
TEST_F(KeepGoing, entryThatCrashesTheReaderEndsTheLog) {
    writeLogThatEndsIn(actionsHoldingAComment());
    expectReadableEntriesWritten();
}

TEST_F(KeepGoing, sweepThatTheDamageCutsIsWrittenWhole) {
    const Observations fans = robot_.sweep();
    Observations log{robot_.localisation()};
    log.insert(log.end(), fans.begin(), fans.begin() + 50);
    writeLog(in_, log, std::nullopt);
    writeFile(in_, readFile(in_) + bytesOf(*fans[50]).substr(0, 100));
    EXPECT_EQ(reduce({"--keep-going"}).exitCode, 0);
    EXPECT_EQ(entriesOf(out_).size(), 51U);
}

TEST_F(KeepGoing, logWithoutPosesIsCopied) {
    writeLog(in_, Observations{robot_.cloud(), robot_.vlp16(), robot_.odometry()});
    const RunResult run = reduce({"--keep-going"});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out, HasSubstr("kept whole: 2 no pose"));
    EXPECT_THAT(run.err, HasSubstr("warning: no scan could be reduced; all points were kept"));
    const auto in = entriesOf(in_), out = entriesOf(out_);
    ASSERT_EQ(out.size(), in.size());
    for (size_t i = 0; i < in.size(); ++i) EXPECT_TRUE(out[i].bytes == in[i].bytes);
    EXPECT_EQ(reduce({"--keep-going", "--strict", "--force"}).exitCode, 3);
}

TEST_F(KeepGoing, logWithoutScansIsCopied) {
    writeLog(in_, Observations{robot_.localisation(), robot_.horizontalScan()});
    const RunResult run = reduce({"--keep-going"});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, HasSubstr("warning: the log holds no 3D scan"));
    EXPECT_EQ(entriesOf(out_).size(), 2U);
}

TEST_F(KeepGoing, logThatIsDamagedFromTheBeginningIsStillRefused) {
    writeFile(in_, "x y z\n1.0 2.0 3.0\n");
    expectRefusal(reduceArguments({"--keep-going"}), 2, HasSubstr("is not a rawlog"));
    writeFile(in_, actionsHoldingAComment());
    expectRefusal(reduceArguments({"--keep-going"}), 2, HasSubstr("entry 0 at byte 0"));
    writeFile(in_, scanOfHugeLength());
    expectRefusal(reduceArguments({"--keep-going"}), 2, HasSubstr("entry 0 at byte 0"));
}

}  // namespace
