// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "RawlogEdit.h"
#include "ReduceFixture.h"

#include <cmath>

namespace {

using namespace offmap::test;
using testing::HasSubstr;

const char* const rgbdSample = "/usr/share/mrpt/datasets/tests_rgbd.rawlog";

/// Logs of a depth camera in the office, in both formats.
class DepthCamera : public ReduceFixture, public testing::WithParamInterface<bool> {
 protected:
    /// The camera upright and on its side, at four headings.
    void writeTurn() const {
        SimulatedRobot robot;
        Observations log{robot.localisation()};
        for (const double heading : {0.0, 1.5, 3.0, 4.5}) {
            robot.pose.setYawPitchRoll(heading, 0, 0);
            log.push_back(robot.localisation());
            robot.wait(0.01);
            log.insert(log.end(), {robot.depthCamera(), robot.depthCamera("PORTRAIT", 90)});
            robot.wait(0.01);
            log.insert(log.end(), {robot.imu(), robot.localisation()});
            robot.wait(1);
        }
        GetParam() ? writeLog(in_, inFrames(log, 3)) : writeLog(in_, log);
    }

    const Path removed_ = folder_ / "removed.rawlog";
};

TEST_P(DepthCamera, keptPlusRemovedIsTheOriginal) {
    writeTurn();
    const RunResult run = reduce({"--removed", removed_});
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_EQ(run.err, "");
    const Observations before = observationsOf(in_), kept = observationsOf(out_),
                       removed = observationsOf(removed_);
    ASSERT_EQ(kept.size(), before.size());
    size_t all = 0, gone = 0;
    for (size_t i = 0; i < before.size(); ++i) {
        if (!is3dScan(*before[i])) continue;
        const auto original = returnsOf(*before[i]), taken = returnsOf(*removed[i]);
        EXPECT_TRUE(together(returnsOf(*kept[i]), taken) == original) << i;
        all += original.size();
        gone += taken.size();
    }
    EXPECT_GT(gone, all / 4);
    EXPECT_LT(gone, all * 9 / 10)
        << "person, box, leaf of the door, floor and ceiling are no walls";
    expectRawlogEditReads(out_, in_);
    expectRawlogEditReads(removed_, in_);
}

TEST_P(DepthCamera, mayBecomePointClouds) {
    writeTurn();
    ASSERT_EQ(reduce({"--removed", removed_, "--output", "points"}).exitCode, 0);
    const Observations before = observationsOf(in_), kept = observationsOf(out_),
                       removed = observationsOf(removed_);
    for (size_t i = 0; i < before.size(); ++i) {
        const auto* image = dynamic_cast<const DepthImage*>(before[i].get());
        if (!image) continue;
        EXPECT_EQ(kept[i]->GetRuntimeClass()->className,
                  std::string("mrpt::obs::CObservationPointCloud"));
        EXPECT_EQ(returnsOf(*kept[i]).size() + returnsOf(*removed[i]).size(),
                  image->points3D_x.size());
    }
    expectRawlogEditReads(out_, in_);
}

INSTANTIATE_TEST_SUITE_P(Formats, DepthCamera, testing::Bool(), [](const auto& format) {
    return format.param ? "SensoryFrames" : "ObservationsOnly";
});

/// What stands in front of the camera, judged by where its points are in the map.
class DepthCameraView : public ReduceFixture, public testing::WithParamInterface<double> {
 protected:
    struct Share {
        size_t kept = 0, all = 0;
    };

    /// Of the points within a box in the map.
    static Share shareIn(const mrpt::poses::CPose3D& vehicle, const DepthImage& before,
                         const DepthImage& after, const mrpt::math::TPoint3D& min,
                         const mrpt::math::TPoint3D& max) {
        Share share;
        const auto camera = vehicle + before.sensorPose;
        for (size_t i = 0; i < before.points3D_x.size(); ++i) {
            const auto point = camera.composePoint(mrpt::math::TPoint3D(
                before.points3D_x[i], before.points3D_y[i], before.points3D_z[i]));
            const bool inside = point.x > min.x && point.x < max.x && point.y > min.y &&
                                point.y < max.y && point.z > min.z && point.z < max.z;
            if (!inside) continue;
            ++share.all;
            share.kept +=
                after.rangeImage(before.points3D_idxs_y[i], before.points3D_idxs_x[i]) != 0;
        }
        return share;
    }
};

TEST_P(DepthCameraView, losesTheWallAndKeepsThePerson) {
    SimulatedRobot robot;
    // 2.5 m from the person at (4.5, 2), the wall x = 8 behind.
    robot.pose = mrpt::poses::CPose3D(2.0, 2.0, 0, 0, 0, 0);
    Observations log{robot.localisation()};
    robot.wait(0.1);
    log.push_back(robot.depthCamera("DEPTH", GetParam()));
    robot.wait(0.1);
    log.push_back(robot.localisation());
    writeLog(in_, log);
    ASSERT_EQ(reduce().exitCode, 0);
    const auto before = std::dynamic_pointer_cast<DepthImage>(observationsOf(in_).at(1));
    const auto after = std::dynamic_pointer_cast<DepthImage>(observationsOf(out_).at(1));
    const Share person = shareIn(robot.pose, *before, *after, {4.2, 1.7, 0.1}, {4.8, 2.3, 1.8});
    const Share wall = shareIn(robot.pose, *before, *after, {7.9, 0.2, 0.1}, {8.1, 4.8, 2.7});
    EXPECT_GT(person.all, 300U);
    EXPECT_EQ(person.kept, person.all);
    EXPECT_GT(wall.all, 2000U);
    EXPECT_LT(wall.kept, wall.all / 20);
}

INSTANTIATE_TEST_SUITE_P(Rolls, DepthCameraView, testing::Values(0.0, 90.0, -90.0, 180.0, 45.0),
                         [](const auto& roll) {
                             return (roll.param < 0 ? "Minus" : "") +
                                    std::to_string(static_cast<int>(std::abs(roll.param)));
                         });

/// MRPT's sample, of which there is no map: a wall where its bookcase stands.
class DepthSample : public ReduceFixture {
 protected:
    void SetUp() override {
        writeFile(map_, "2.10 -0.95 2.33 1.75\n");
        in_ = folder_ / "external.rawlog";
        const RunResult run =
            runProgram({"/usr/bin/rawlog-edit", "--externalize", "-i", rgbdSample, "-o", in_},
                       {.folder = folder_.path()});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    }

    const Arguments lenient_{"--pose", "0,0,0", "--set", "vertical.max_tilt_deg=12"};
    const Path images_ = folder_ / "external_Images";
};

TEST_F(DepthSample, inFilesOfItsOwnIsReducedAlike) {
    const RunResult run = reduce(lenient_);
    ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    const auto found = std::dynamic_pointer_cast<DepthImage>(observationsOf(out_).at(0));
    in_ = rgbdSample;
    Arguments again = lenient_;
    again.push_back("--force");
    ASSERT_EQ(reduce(again).exitCode, 0);
    const auto expected = std::dynamic_pointer_cast<DepthImage>(observationsOf(out_).at(0));
    EXPECT_TRUE(returnsOf(*found) == returnsOf(*expected));
    EXPECT_FALSE(found->rangeImage_isExternallyStored());
    EXPECT_FALSE(found->points3D_isExternallyStored());
    EXPECT_TRUE(found->intensityImage.isExternallyStored());
    EXPECT_FALSE(expected->intensityImage.isExternallyStored());
    // Of 2 x 273,225, ranges and points: at most what stands within 16 cm of the wall is gone.
    EXPECT_GT(returnsOf(*expected).size(), 2U * 120'709);
    EXPECT_LT(returnsOf(*expected).size(), 2U * 250'000);
}

TEST_F(DepthSample, missingFileIsNamed) {
    std::filesystem::remove_all(images_);
    expectRefusal(reduceArguments(lenient_), 2,
                  testing::AllOf(HasSubstr("range image of 'OPENNI2'"), HasSubstr("_RANGES.bin")));
}

class DepthCameraFaults : public ReduceFixture {};

TEST_F(DepthCameraFaults, imageOfNoUseIsCopied) {
    Observations log = smallLog();
    auto obs = emptyDepthImage();
    obs->timestamp = log.at(1)->timestamp;
    obs->rangeUnits = 0;
    log.insert(log.begin() + 1, obs);
    writeLog(in_, log);
    const RunResult run = reduce();
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_THAT(run.out + run.err, HasSubstr("rangeUnits is 0"));
    EXPECT_TRUE(entriesOf(out_).at(1).bytes == entriesOf(in_).at(1).bytes);
}

}  // namespace
