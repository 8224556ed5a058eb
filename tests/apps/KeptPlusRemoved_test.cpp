// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <offmap/rawlog/ScanClasses.h>

#include <numeric>
#include <random>

namespace {

using namespace offmap::test;

/// The scans of a log, each one's returns.
std::vector<std::vector<Return>> scansOf(const std::filesystem::path& file) {
    std::vector<std::vector<Return>> scans;
    for (const auto& obs : observationsOf(file)) {
        if (is3dScan(*obs)) scans.push_back(returnsOf(*obs));
    }
    return scans;
}

std::vector<std::vector<Return>> scansAsPointClouds(const std::filesystem::path& file) {
    std::vector<std::vector<Return>> scans;
    for (const auto& obs : observationsOf(file)) {
        if (!is3dScan(*obs)) continue;
        const auto* scanClass = offmap::rawlog::scanClassOf(*obs, {});
        const std::vector<uint8_t> all(scanClass->slotCount(*obs), 1);
        scans.push_back(returnsOf(*scanClass->asPointCloud(*obs, all, {})));
    }
    return scans;
}

class KeptPlusRemoved : public ReduceFixture, public testing::WithParamInterface<bool> {
 protected:
    /// Both parts together are the original, and both are worth speaking of.
    void expectParts(const std::vector<std::vector<Return>>& original) const {
        const auto kept = scansOf(out_), removed = scansOf(removed_);
        ASSERT_EQ(kept.size(), original.size());
        ASSERT_EQ(removed.size(), original.size());
        size_t keptReturns = 0, removedReturns = 0;
        for (size_t i = 0; i < original.size(); ++i) {
            EXPECT_TRUE(together(kept[i], removed[i]) == original[i]) << "scan " << i;
            keptReturns += kept[i].size();
            removedReturns += removed[i].size();
        }
        EXPECT_GT(keptReturns, 1000U);
        EXPECT_GT(removedReturns, 1000U);
    }

    void writeSeconds(uint64_t seed) const {
        SimulatedRobot robot(seed);
        robot.pose.x(1.5 + 0.1 * static_cast<double>(seed));
        robot.pose.setYawPitchRoll(1.7 * static_cast<double>(seed), 0, 0);
        const Observations log = secondsOf(robot, 1);
        GetParam() ? writeLog(in_, inFrames(log, 3)) : writeLog(in_, log);
    }

    const Path removed_ = folder_ / "removed.rawlog";
};

TEST_P(KeptPlusRemoved, isTheOriginal) {
    for (const uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        writeSeconds(seed);
        ASSERT_EQ(reduce({"--removed", removed_, "--force"}).exitCode, 0);
        expectParts(scansOf(in_));
    }
}

TEST_P(KeptPlusRemoved, isTheOriginalAsPointClouds) {
    for (const uint64_t seed : {4, 5}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        writeSeconds(seed);
        ASSERT_EQ(reduce({"--removed", removed_, "--output", "points", "--force"}).exitCode, 0);
        expectParts(scansAsPointClouds(in_));
        for (const auto& obs : observationsOf(out_)) {
            EXPECT_FALSE(std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(obs));
            if (obs->sensorLabel == "SWEEP") {
                EXPECT_TRUE(std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(obs));
            }
        }
    }
}

TEST_P(KeptPlusRemoved, isTheSameInEveryRun) {
    writeSeconds(6);
    ASSERT_EQ(reduce({"--removed", removed_}).exitCode, 0);
    const std::string kept = readFile(out_), removed = readFile(removed_);
    const TemporaryFolder elsewhere;
    const Path other = elsewhere / "another name", otherRemoved = elsewhere / "removed";
    const RunResult again =
        runOffmap({"reduce", in_, "--map", map_, "-o", other, "--removed", otherRemoved});
    ASSERT_EQ(again.exitCode, 0);
    EXPECT_TRUE(readFile(other) == kept);
    EXPECT_TRUE(readFile(otherRemoved) == removed);
}

INSTANTIATE_TEST_SUITE_P(Formats, KeptPlusRemoved, testing::Bool(), [](const auto& format) {
    return format.param ? "SensoryFrames" : "ObservationsOnly";
});

class Shuffling : public ReduceFixture {
 protected:
    std::vector<Return> reducedCloud(const mrpt::obs::CObservation::Ptr& cloud) {
        writeLog(in_, Observations{robot_.localisation(), cloud});
        EXPECT_EQ(reduce({"--force"}).exitCode, 0);
        return returnsOf(*observationsOf(out_).at(1));
    }

    SimulatedRobot robot_;
};

TEST_F(Shuffling, changesNoLabelOfACloud) {
    const auto cloud = robot_.cloud();
    auto shuffled = std::make_shared<mrpt::obs::CObservationPointCloud>(*cloud);
    auto points = mrpt::maps::CPointsMapXYZI::Create();
    std::vector<size_t> order(cloud->pointcloud->size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(11));
    for (const size_t i : order) {
        float x = 0, y = 0, z = 0, intensity = 0, unused = 0;
        cloud->pointcloud->getPointRGB(i, x, y, z, intensity, unused, unused);
        points->insertPointRGB(x, y, z, intensity, 0, 0);
    }
    shuffled->pointcloud = points;
    const auto left = reducedCloud(cloud);
    EXPECT_TRUE(reducedCloud(shuffled) == left);
    EXPECT_LT(left.size(), order.size() * 3 / 4);
}

}  // namespace
