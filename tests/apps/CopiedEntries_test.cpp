// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "../support/Scans.h"
#include "ReduceFixture.h"

namespace {

using namespace offmap::test;

class CopiedEntries : public ReduceFixture {
 protected:
    void reduceAll() {
        const RunResult run = reduce({"--removed", removed_});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        original_ = entriesOf(in_);
    }

    /// Same entries, order, classes, times and labels; what is no 3D scan has the same bytes.
    void expectOnlyScansDiffer(const Path& output) const {
        const auto entries = entriesOf(output);
        ASSERT_EQ(entries.size(), original_.size());
        size_t differing = 0;
        for (size_t i = 0; i < entries.size(); ++i) {
            SCOPED_TRACE("entry " + std::to_string(i));
            const Observations before = observationsOf(original_[i]);
            const Observations after = observationsOf(entries[i]);
            ASSERT_EQ(after.size(), before.size());
            bool has3d = false;
            for (size_t m = 0; m < before.size(); ++m) {
                EXPECT_EQ(after[m]->timestamp, before[m]->timestamp);
                EXPECT_EQ(after[m]->sensorLabel, before[m]->sensorLabel);
                EXPECT_EQ(after[m]->GetRuntimeClass(), before[m]->GetRuntimeClass());
                has3d = has3d || is3dScan(*before[m]);
                if (!is3dScan(*before[m])) {
                    EXPECT_TRUE(bytesOf(*after[m]) == bytesOf(*before[m]))
                        << before[m]->sensorLabel;
                }
            }
            EXPECT_TRUE(has3d || entries[i].bytes == original_[i].bytes);
            differing += entries[i].bytes != original_[i].bytes;
        }
        EXPECT_GT(differing, original_.size() / 4);
    }

    const Path removed_ = folder_ / "removed.rawlog";
    std::vector<LogEntry> original_;
};

TEST_F(CopiedEntries, keepTheirBytesAmongObservations) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 2));
    reduceAll();
    expectOnlyScansDiffer(out_);
    expectOnlyScansDiffer(removed_);
}

TEST_F(CopiedEntries, keepTheirBytesAmongFrames) {
    SimulatedRobot robot;
    writeLog(in_, inFrames(secondsOf(robot, 2)));
    reduceAll();
    expectOnlyScansDiffer(out_);
    expectOnlyScansDiffer(removed_);
}

// Written anew, the entries of an older MRPT would differ.
TEST_F(CopiedEntries, ofOlderVersionsKeepTheirBytes) {
    const Path old = "/usr/share/mrpt/datasets/localization_demo.rawlog";
    std::string log;
    bool differs = false;
    for (const LogEntry& entry : entriesOf(old)) {
        log += entry.bytes;
        differs = differs || bytesOf(*entry.object) != entry.bytes;
    }
    ASSERT_TRUE(differs) << "they would be kept in any case";
    writeLog(in_, smallLog(), std::nullopt);
    writeFile(in_, log + readFile(in_));
    reduceAll();
    const size_t count = original_.size() - 3;
    const auto out = entriesOf(out_), removed = entriesOf(removed_);
    ASSERT_EQ(out.size(), original_.size());
    for (size_t i = 0; i < count; ++i) {
        EXPECT_TRUE(out[i].bytes == original_[i].bytes) << "entry " << i;
        EXPECT_TRUE(removed.at(i).bytes == original_[i].bytes) << "entry " << i;
    }
    EXPECT_FALSE(out[count + 1].bytes == original_[count + 1].bytes) << "the cloud is reduced";
}

TEST_F(CopiedEntries, sensorsThatAreNotChosenKeepTheirBytes) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    ASSERT_EQ(reduce({"--sensor", "CLOUD"}).exitCode, 0);
    const auto in = entriesOf(in_), out = entriesOf(out_);
    ASSERT_EQ(out.size(), in.size());
    for (size_t i = 0; i < in.size(); ++i) {
        const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation>(in[i].object);
        EXPECT_EQ(out[i].bytes == in[i].bytes, obs->sensorLabel != "CLOUD") << obs->sensorLabel;
    }
}

}  // namespace
