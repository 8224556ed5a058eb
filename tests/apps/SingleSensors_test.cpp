// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

// What holds for one sensor only.

namespace {

using namespace offmap::test;
using mrpt::obs::CObservationPointCloud;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// [m] from the sensor to each return.
std::vector<double> rangesOf(const mrpt::obs::CObservation& obs) {
    std::vector<double> ranges;
    for (const Return& r : returnsOf(obs)) {
        if (dynamic_cast<const CObservationPointCloud*>(&obs)) {
            ranges.push_back(std::hypot(r[0], r[1], r[2]));
        } else {
            const bool fan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs);
            ranges.push_back(fan ? r[1] : 0.002 * r[3]);
        }
    }
    return ranges;
}

class SingleSensors : public ReduceFixture {
 protected:
    json reportOf(const Arguments& more) {
        Arguments arguments{"--report", report_, "--force"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = reduce(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return json::parse(readFile(report_));
    }

    /// The entry of the report's only scan of a sensor.
    static json scanOf(const json& report, const std::string& label) {
        for (const json& scan : report["scans"]) {
            if (scan["sensor"] == label) return scan;
        }
        return {};
    }

    std::vector<Return> reducedCloud(const Arguments& more) {
        EXPECT_EQ(reduce(more).exitCode, 0);
        return returnsOf(*observationsOf(out_).at(1));
    }

    const Path report_ = folder_ / "report.json";
    SimulatedRobot robot_;
};

TEST_F(SingleSensors, twoLidarsAreReducedEachByItsOwnSettings) {
    writeLog(in_, Observations{robot_.localisation(), robot_.cloud("lidar.left"),
                               robot_.cloud("lidar.right")});
    const json report =
        reportOf({"--set", "sensors.lidar.left.column_width_deg=6", "--set",
                  "sensors.lidar.right.min_range_m=100", "--set", "sensor.column_width_deg=3"});
    const json left = scanOf(report, "lidar.left"), right = scanOf(report, "lidar.right");
    EXPECT_EQ(left["columns"], 60);  // of 120, 3 degrees apart
    EXPECT_GT(left["points_removed"], 100);
    EXPECT_EQ(left["points_of_robot"], 0);
    EXPECT_EQ(right["points_removed"], 0);
    EXPECT_EQ(right["points_of_robot"], right["points"]);
    EXPECT_EQ(report["totals"]["points_of_robot"], right["points"]);
    EXPECT_EQ(report["parameters"]["sensors.lidar.left.column_width_deg"], "6");
    EXPECT_EQ(report["parameters"]["sensors.lidar.right.min_range_m"], "100");
    EXPECT_EQ(report["parameters"]["sensor.min_range_m"], "0");
    EXPECT_EQ(report["warnings"], json::array());
}

TEST_F(SingleSensors, fileAndCommandLineSayTheSame) {
    writeLog(in_, Observations{robot_.localisation(), robot_.cloud("A"), robot_.cloud("B")});
    ASSERT_EQ(
        reduce({"--set", "sensors.A.min_range_m=2", "--set", "sensors.B.robot_box_m=-1,3,-1,1,0,2"})
            .exitCode,
        0);
    const std::string bySet = readFile(out_);
    const Path config = folder_ / "own.yaml";
    writeFile(config,
              "sensors:\n  A: {min_range_m: 2}\n  B: {robot_box_m: [-1, 3, -1, 1, 0, 2]}\n");
    ASSERT_EQ(reduce({"--config", config, "--force"}).exitCode, 0);
    EXPECT_TRUE(readFile(out_) == bySet);
    ASSERT_EQ(reduce({"--force"}).exitCode, 0);
    EXPECT_FALSE(readFile(out_) == bySet);
}

TEST_F(SingleSensors, settingsOfASensorThatIsNotThereAreTold) {
    writeLog(in_, smallLog());
    const Arguments typo{"--set", "sensors.CLUOD.min_range_m=1"};
    const auto warning = AllOf(HasSubstr("sensors.CLUOD.*"), HasSubstr("of: CLOUD"));
    EXPECT_THAT(reduce(typo).err, AllOf(HasSubstr("warning: "), warning));
    EXPECT_THAT(reportOf(typo)["warnings"], ElementsAre(warning));
    const Arguments render{"render", in_, "--map", map_, "-o", folder_ / "a.png", typo[0], typo[1]};
    EXPECT_THAT(runOffmap(render).err, AllOf(HasSubstr("warning: "), warning));
}

TEST_F(SingleSensors, givenPoseHoldsInsteadOfTheLogsAndIsNotWritten) {
    const auto cloud = robot_.cloud();
    writeLog(in_, Observations{robot_.localisation(), cloud});
    // By the paper's method, which takes a mounting at its word.
    const Arguments byWord{"--force", "--method", "paper"};
    const std::vector<Return> expected = reducedCloud(byWord);

    cloud->sensorPose = {0.4, 0.1, 1.3, 0, 0, 0};  // truly at -0.2,0.1,1.3 and turned by 0.5 rad
    writeLog(in_, Observations{robot_.localisation(), cloud});
    EXPECT_NE(reducedCloud(byWord), expected);
    const std::string truth = "-0.2,0.1,1.3,28.6478897565412,0,0";  // 0.5 rad
    const auto corrected =
        reducedCloud({"--force", "--method", "paper", "--sensor-pose", "CLOUD=" + truth});
    EXPECT_EQ(corrected, expected);
    EXPECT_LT(corrected.size(), cloud->pointcloud->size() * 2 / 3);
    mrpt::poses::CPose3D written;
    observationsOf(out_).at(1)->getSensorPose(written);
    EXPECT_EQ(written, cloud->sensorPose);
    EXPECT_EQ(reportOf({"--sensor-pose", "CLOUD=" + truth})["sensor_poses"]["CLOUD"],
              "-0.2,0.1,1.3,28.6478897565,0,0");  // to 12 digits
}

TEST_F(SingleSensors, poseOfOneSensorLeavesTheOtherAlone) {
    Observations log{robot_.localisation(), robot_.cloud("A"), robot_.cloud("B")};
    writeLog(in_, log);
    const json before = reportOf({});
    const json after = reportOf({"--sensor-pose", "A=0,0,1,180,0,0"});
    EXPECT_LT(scanOf(after, "A")["points_removed"], scanOf(before, "A")["points_removed"]);
    EXPECT_EQ(scanOf(after, "B")["points_removed"], scanOf(before, "B")["points_removed"]);
}

TEST_F(SingleSensors, givenPoseHoldsForPictures) {
    writeLog(in_, smallLog());
    const auto pictureWith = [&](const Arguments& more) {
        Arguments all{"render", in_, "--map", map_, "--force", "-o", folder_ / "a.png"};
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(runOffmap(all).exitCode, 0);
        return readFile(folder_ / "a.png");
    };
    EXPECT_FALSE(pictureWith({"--sensor-pose", "CLOUD=0,0,1,180,0,0"}) == pictureWith({}));
}

TEST_F(SingleSensors, ownReturnsAreKeptOfEveryClass) {
    writeLog(in_, secondsOf(robot_, 1));
    const Path removed = folder_ / "removed.rawlog";
    const json totals =
        reportOf({"--removed", removed, "--set", "sensor.min_range_m=2.5"})["totals"];
    EXPECT_GT(totals["points_of_robot"], 1000);
    EXPECT_GT(totals["points_removed"], 1000);
    const auto original = observationsOf(in_), kept = observationsOf(out_),
               taken = observationsOf(removed);
    for (size_t i = 0; i < original.size(); ++i) {
        if (!is3dScan(*original[i])) continue;
        EXPECT_EQ(together(returnsOf(*kept[i]), returnsOf(*taken[i])), returnsOf(*original[i]));
        // The steps of a Velodyne are 2 mm, and its points are rounded.
        for (const double range : rangesOf(*taken[i])) EXPECT_GT(range, 2.499);
    }
    EXPECT_THAT(reduce({"--force", "--set", "sensor.min_range_m=2.5"}).out,
                HasSubstr("of the robot itself, kept"));
}

}  // namespace
