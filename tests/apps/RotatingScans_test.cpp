// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "RawlogEdit.h"
#include "ReduceFixture.h"

#include <offmap/rawlog/RotatingScan.h>

#include <limits>

namespace {

using namespace offmap::test;
using mrpt::obs::CObservationRotatingScan;
using testing::AllOf;
using testing::HasSubstr;

const std::string elevations = "sensor.elevations_deg=" + rotatingElevationsText();

class RotatingScans : public ReduceFixture {
 protected:
    /// A log of one scan between two poses.
    void writeScan(const mrpt::obs::CObservation::Ptr& scan) {
        Observations log{robot_.localisation(), scan};
        robot_.wait(0.2);
        log.push_back(robot_.localisation());
        writeLog(in_, log);
    }

    mrpt::obs::CObservation::Ptr reducedScan(const Arguments& more) const {
        EXPECT_EQ(reduce(more).exitCode, 0);
        return observationsOf(out_).at(1);
    }

    /// What is left of each scan in a log.
    static std::vector<std::vector<Return>> scansOf(const Path& file) {
        std::vector<std::vector<Return>> scans;
        for (const auto& obs : observationsOf(file)) {
            if (is3dScan(*obs)) scans.push_back(returnsOf(*obs));
        }
        return scans;
    }

    void expectSample(const std::string& name, size_t returns, size_t removed) {
        map_ = sourceFile("share/maps/vlp16_demo.lines");
        const Path sample = "/usr/share/mrpt/datasets/" + name, rest = folder_ / "removed.rawlog";
        const RunResult run = reduceLog(sample, {"--config", sourceFile("config/vlp16.yaml"),
                                                 "--pose", "0,0,0", "--removed", rest});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto all = scansOf(sample), kept = scansOf(out_), gone = scansOf(rest);
        ASSERT_EQ(all.size(), 1U);
        EXPECT_EQ(all[0].size(), returns);
        EXPECT_EQ(gone.at(0).size(), removed);
        EXPECT_TRUE(together(kept.at(0), gone.at(0)) == all[0]);
    }

    SimulatedRobot robot_;
};

TEST_F(RotatingScans, areReducedLikeACloudOfTheirPoints) {
    const auto scan = robot_.rotatingScan();
    offmap::rawlog::SensorConfig config;
    for (const double e : rotatingElevations()) config.elevations.push_back(mrpt::DEG2RAD(e));
    const offmap::rawlog::RotatingScan scanClass;
    std::vector<uint8_t> all(scanClass.slotCount(*scan), 1);
    const auto cloud = scanClass.asPointCloud(*scan, all, config);
    writeScan(cloud);
    const auto leftOfCloud = reducedScan({"--force"});

    writeScan(scan);
    const auto left = dynamic_cast<const CObservationRotatingScan&>(
        *reducedScan({"--force", "--set", elevations}));
    EXPECT_TRUE(returnsOf(*scanClass.asPointCloud(left, all, config)) == returnsOf(*leftOfCloud));
    EXPECT_LT(returnsOf(left).size(), returnsOf(*scan).size() * 2 / 3) << "walls, not the floor";
}

/// Which format a log has.
class RotatingParts : public RotatingScans, public testing::WithParamInterface<bool> {};

TEST_P(RotatingParts, togetherAreTheOriginal) {
    const Path removed = folder_ / "removed.rawlog";
    for (const char* output : {"same", "points"}) {
        Observations log{robot_.localisation()};
        for (int i = 0; i < 3; ++i) {
            const auto scan = robot_.rotatingScan();
            if (i > 0) addLastReturns(*scan);
            log.push_back(scan);
            robot_.wait(0.3);
            log.insert(log.end(), {robot_.imu(), robot_.localisation()});
        }
        GetParam() ? writeLog(in_, inFrames(log, 3)) : writeLog(in_, log);
        ASSERT_EQ(reduce({"--set", elevations, "--removed", removed, "--output", output, "--force"})
                      .exitCode,
                  0);
        expectRawlogEditReads(out_, in_);
        expectRawlogEditReads(removed, in_);
        const auto original = scansOf(in_), kept = scansOf(out_), gone = scansOf(removed);
        ASSERT_EQ(kept.size(), 3U);
        ASSERT_EQ(gone.size(), 3U);
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_GT(kept[i].size(), 1000U);
            EXPECT_GT(gone[i].size(), 1000U);
            EXPECT_EQ(kept[i].size() + gone[i].size(), original[i].size());
            if (output != std::string("same")) continue;
            EXPECT_TRUE(together(kept[i], gone[i]) == original[i]) << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, RotatingParts, testing::Bool(), [](const auto& format) {
    return format.param ? "SensoryFrames" : "ObservationsOnly";
});

// The Velodyne's own packets hold 22,591 returns; of them MRPT took over every second one, and of
// the 682 that are removed there about half.
TEST_F(RotatingScans, sampleOfAVelodyneIsReduced) {
    expectSample("rot_scan_velodyne.rawlog", 11'305, 341);
}

TEST_F(RotatingScans, singleRingLosesNothing) {
    expectSample("rot_scan_2d.rawlog", 359, 0);
    EXPECT_THAT(reduce({"--pose", "0,0,0", "--force"}).err,
                HasSubstr("no vertical segment was found"));
}

TEST_F(RotatingScans, unknownModelAsksForItsElevations) {
    writeScan(robot_.rotatingScan());
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("ROTATING (1 x CObservationRotatingScan"),
                        HasSubstr("the model \"SIMULATED\""),
                        HasSubstr("elevations of its 32 rows with sensor.elevations_deg")));
}

TEST_F(RotatingScans, wrongNumberOfElevationsIsRefused) {
    writeScan(robot_.rotatingScan());
    expectRefusal(reduceArguments({"--set", "sensor.elevations_deg=[1, 2, 3]"}), 2,
                  AllOf(HasSubstr("gives 3 elevations"), HasSubstr("32 rows")));
}

TEST_F(RotatingScans, wrongAzimuthSenseIsRefused) {
    writeScan(robot_.rotatingScan());
    expectRefusal(reduceArguments({"--set", elevations, "--set", "sensor.azimuth=left"}), 1,
                  AllOf(HasSubstr("sensor.azimuth"), HasSubstr("auto, ccw, cw")));
}

TEST_F(RotatingScans, damagedOnesAreCopiedAndTold) {
    const auto whole = robot_.rotatingScan();
    Observations log{robot_.localisation(), whole};
    for (int damage = 0; damage < 3; ++damage) {
        const auto scan = std::make_shared<CObservationRotatingScan>(*whole);
        if (damage == 0) scan->columnCount = 65535;
        if (damage == 1) scan->rangeResolution = std::numeric_limits<double>::quiet_NaN();
        if (damage == 2) scan->azimuthSpan = 1e300;
        log.push_back(scan);
    }
    robot_.wait(0.2);
    log.push_back(robot_.localisation());
    writeLog(in_, log);
    const RunResult run = reduce({"--set", elevations});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.err, AllOf(HasSubstr("32 x 360, not 32 rows x 65535 columns"),
                               HasSubstr("rangeResolution is"), HasSubstr("azimuthSpan is")));
    const auto before = entriesOf(in_), after = entriesOf(out_);
    ASSERT_EQ(after.size(), before.size());
    EXPECT_FALSE(after[1].bytes == before[1].bytes) << "the whole one is reduced";
    for (size_t i = 2; i < before.size(); ++i) EXPECT_TRUE(after[i].bytes == before[i].bytes) << i;
}

TEST_F(RotatingScans, flippedBytesAreReadOrRefused) {
    const auto scan = robot_.rotatingScan("ROTATING", 24);
    addLastReturns(*scan);
    writeLog(in_, Observations{scan, robot_.localisation()}, std::nullopt);
    const std::string whole = readFile(in_);
    std::mt19937 random(25);
    int refused = 0;
    for (int trial = 0; trial < 40; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        // Every other one in the head, where the sizes stand.
        const size_t range = trial % 2 == 0 ? whole.size() : 100;
        refused += !reducesOrRefuses(withByteFlipped(whole, range, random), {"--set", elevations});
    }
    EXPECT_GT(refused, 5) << "a third of the head is the name of the class";
}

}  // namespace
