// SPDX-License-Identifier: BSD-3-Clause
#include "../support/LogFiles.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/LogInventory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace offmap::rawlog;
using namespace offmap::test;

/// A log and what was counted in it.
class Counted {
 public:
    template <class Pointers>
    explicit Counted(const Pointers& objects, std::vector<PoseCoverage*> coverages = {}) {
        writeLog(file_, objects);
        RawlogReader first(file_), second(file_);
        survey_ = surveyLog(first, config_, std::numeric_limits<uint64_t>::max(), [] {});
        LogInventory& inventory = inventory_.emplace(survey_, config_, file_,
                                                     std::set<std::string>{}, std::move(coverages));
        while (const auto entry = second.next()) inventory.add(*entry);
        inventory.finish();
    }

    const LogInventory& inventory() const { return *inventory_; }
    const SensorInventory& sensor(const std::string& label, const std::string& name) const {
        return inventory_->sensors().at({label, name});
    }

 private:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "in.rawlog";
    Config config_;
    LogSurvey survey_;
    std::optional<LogInventory> inventory_;
};

TEST(LogInventory, countsScansAndTheirPoints) {
    SimulatedRobot robot;
    const Observations log = secondsOf(robot, 2);
    uint64_t cloudPoints = 0;
    for (const auto& obs : log) {
        const auto* cloud = dynamic_cast<mrpt::obs::CObservationPointCloud*>(obs.get());
        if (cloud) cloudPoints += cloud->pointcloud->size();
    }
    const Counted counted(log);
    const auto& vlp16 = counted.sensor("VLP16", "CObservationVelodyneScan");
    EXPECT_EQ(vlp16.scans, 2U);
    EXPECT_EQ(vlp16.reducible, 2U);
    EXPECT_EQ(vlp16.model.name, "VLP-16");
    const auto& cloud = counted.sensor("CLOUD", "CObservationPointCloud");
    EXPECT_EQ(cloud.counts.returns, cloudPoints);
    const auto& sweep = counted.sensor("SWEEP", "CObservation2DRangeScan");
    EXPECT_EQ(sweep.observations, 180U);
    EXPECT_EQ(sweep.scans, 2U);
    EXPECT_TRUE(sweep.mountingVaries);
    EXPECT_FALSE(cloud.mountingVaries);
    EXPECT_NEAR(cloud.mounting->z(), 1.3, 1e-9);
    EXPECT_FALSE(counted.sensor("FRONT_LASER", "CObservation2DRangeScan").scans3d);
    EXPECT_EQ(counted.sensor("IMU", "CObservationIMU").observations, 4U);
}

TEST(LogInventory, ratesAndTimesAreThoseOfTheStamps) {
    SimulatedRobot robot;
    Observations log;
    for (int i = 0; i < 11; ++i) {
        log.push_back(robot.imu());
        robot.wait(0.25);
    }
    const Counted counted(log);
    const auto& span = *counted.inventory().span();
    // A stamp is a double of 1.7e9 s, that is to 2.4e-7 s.
    EXPECT_NEAR(mrpt::Clock::toDouble(span.end) - mrpt::Clock::toDouble(span.begin), 2.5, 1e-6);
    EXPECT_NEAR(*counted.sensor("IMU", "CObservationIMU").interval.rate(), 4, 1e-4);
    EXPECT_EQ(counted.inventory().scanSpan().has_value(), false);
}

TEST(LogInventory, countsActionsAndFrames) {
    SimulatedRobot robot;
    const Observations log = secondsOf(robot, 1);
    const Counted counted(inFrames(log));
    const EntryCounts& entries = counted.inventory().entries();
    // The comment stays an entry of its own; four of the others make a frame.
    EXPECT_EQ(entries.observations, 1U);
    EXPECT_EQ(entries.sensoryFrames, (log.size() - 1 + 3) / 4);
    EXPECT_EQ(entries.actionCollections, entries.sensoryFrames);
    EXPECT_EQ(entries.actions.at("CActionRobotMovement2D"), entries.actionCollections);
    EXPECT_EQ(counted.sensor("VLP16", "CObservationVelodyneScan").scans, 1U);
}

TEST(LogInventory, oneLabelOfTwoClassesIsTwoSensors) {
    SimulatedRobot robot;
    const Counted counted(Observations{robot.cloud("A"), robot.localisation("A")});
    EXPECT_EQ(counted.inventory().sensors().size(), 2U);
}

TEST(LogInventory, observationsWithoutTimeAreCountedApart) {
    SimulatedRobot robot;
    const auto cloud = robot.cloud();
    cloud->timestamp = {};
    const Counted counted(Observations{cloud, robot.imu()});
    EXPECT_EQ(counted.inventory().entries().withoutTime, 1U);
    EXPECT_EQ(counted.sensor("CLOUD", "CObservationPointCloud").scans, 1U);
    EXPECT_EQ(counted.inventory().span()->begin, robot.now);
}

TEST(LogInventory, asksForThePoseOfEvery3dObservation) {
    const FixedPose pose({1, 2, 0}, 0.05, 0.01);
    PoseCoverage coverage(pose, {});
    SimulatedRobot robot;
    const Counted counted(secondsOf(robot, 1), {&coverage});
    EXPECT_EQ(coverage.observations(), 92U);  // a VLP-16's, a cloud, 90 columns
    EXPECT_EQ(coverage.covered(), 92U);
}

TEST(LogInventory, externalFileThatIsGoneIsTold) {
    SimulatedRobot robot;
    const auto cloud = robot.cloud();
    cloud->setAsExternalStorage(
        "gone.bin", mrpt::obs::CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
    const Counted counted(Observations{cloud});
    const auto& sensor = counted.sensor("CLOUD", "CObservationPointCloud");
    EXPECT_EQ(sensor.external, 1U);
    EXPECT_EQ(sensor.externalMissing, 1U);
    EXPECT_THAT(sensor.externalProblem, testing::HasSubstr("gone.bin"));
    EXPECT_EQ(sensor.scans, 0U);
}

}  // namespace
