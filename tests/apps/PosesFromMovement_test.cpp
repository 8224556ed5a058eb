// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <fmt/format.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace {

using namespace offmap::test;
using mrpt::obs::CObservationOdometry;
using testing::AllOf;
using testing::HasSubstr;

/// One drive through the office, told in several ways: a cloud at each of five places.
class PosesFromMovement : public ReduceFixture {
 protected:
    PosesFromMovement() {
        const auto begin = robot_.pose;
        for (int i = 0; i < 5; ++i) {
            const auto before = robot_.pose;
            robot_.pose = before + mrpt::poses::CPose3D(0.25, 0, 0, 0.1, 0, 0);
            robot_.wait(2);
            clouds_.push_back(robot_.cloud());
            localisations_.push_back(robot_.localisation());
            actions_.push_back(actionOf(robot_.pose - before));
            odometry_.push_back(odometryAt(robot_.pose - begin));
            trajectory_ += tumLine();
        }
        writeLog(in_, interleaved(localisations_, clouds_));
        byRobotPoses_ = removedBy({});
    }

    static mrpt::obs::CActionCollection::Ptr actionOf(const mrpt::poses::CPose3D& increment) {
        mrpt::obs::CActionRobotMovement2D::TMotionModelOptions certain;
        certain.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
        auto& model = certain.gaussianModel;
        model.a1 = model.a2 = model.a3 = model.a4 = 0.01F;
        model.minStdXY = 0.002F;   // [m]
        model.minStdPHI = 0.001F;  // [rad]
        mrpt::obs::CActionRobotMovement2D movement;
        movement.computeFromOdometry(mrpt::poses::CPose2D(increment), certain);
        auto actions = mrpt::obs::CActionCollection::Create();
        actions->insert(movement);
        return actions;
    }

    /// Wheels count from anywhere.
    CObservationOdometry::Ptr odometryAt(const mrpt::poses::CPose3D& sinceBegin) const {
        auto odometry = robot_.odometry();
        odometry->odometry = mrpt::poses::CPose2D(7, -3, 2) + mrpt::poses::CPose2D(sinceBegin);
        return odometry;
    }

    std::string tumLine() const {
        mrpt::math::CQuaternionDouble q;
        robot_.pose.getAsQuaternion(q);
        return fmt::format("{:.6f} {} {} {} {} {} {} {}\n", mrpt::Clock::toDouble(robot_.now),
                           robot_.pose.x(), robot_.pose.y(), robot_.pose.z(), q.x(), q.y(), q.z(),
                           q.r());
    }

    template <class Poses>
    static Observations interleaved(const Poses& poses, const Observations& clouds) {
        Observations log;
        for (size_t i = 0; i < clouds.size(); ++i) log.insert(log.end(), {poses[i], clouds[i]});
        return log;
    }

    Objects actionsAndFrames() const {
        Objects log;
        for (size_t i = 0; i < clouds_.size(); ++i) {
            auto frame = mrpt::obs::CSensoryFrame::Create();
            frame->push_back(clouds_[i]);
            log.insert(log.end(), {actions_[i], frame});
        }
        return log;
    }

    /// Points that are removed in all; every cloud must be reduced.
    double removedBy(Arguments arguments) {
        const auto report = folder_ / "report.json";
        arguments.insert(arguments.end(), {"--report", report, "--strict", "--force"});
        run_ = reduce(arguments);
        EXPECT_EQ(run_.exitCode, 0) << testing::PrintToString(run_);
        return nlohmann::json::parse(readFile(report))["totals"]["points_removed"].get<double>();
    }

    /// The poses are the true ones, as uncertain but for what the way of a metre adds: only returns
    /// at the very edge of a gate may differ, fewer than one in a hundred.
    void expectSameReduction(double removed) const {
        EXPECT_GT(byRobotPoses_, 5000) << "five clouds, of some 3000 points each";
        EXPECT_NEAR(removed / byRobotPoses_, 1, 0.01);
    }

    SimulatedRobot robot_;
    Observations clouds_;
    std::vector<mrpt::obs::CObservationRobotPose::Ptr> localisations_;
    std::vector<mrpt::obs::CActionCollection::Ptr> actions_;
    std::vector<CObservationOdometry::Ptr> odometry_;
    std::string trajectory_;
    double byRobotPoses_ = 0;
    RunResult run_;
};

// Where the robot was before its first movement, 0.3 rad; and after it, when odometry begins.
constexpr const char* beforeFirst = "2,2.5,17.188734";
const std::string sigmas = "0.02,0.5";  // as of the robot poses

std::string first() {
    const auto pose = SimulatedRobot().pose + mrpt::poses::CPose3D(0.25, 0, 0, 0.1, 0, 0);
    return fmt::format("{},{},{}", pose.x(), pose.y(), mrpt::RAD2DEG(pose.yaw()));
}

TEST_F(PosesFromMovement, actionsReduceAsWellAsRobotPoses) {
    writeLog(in_, actionsAndFrames());
    expectSameReduction(removedBy({"--initial-pose", beforeFirst, "--pose-sigma", sigmas}));
    EXPECT_THAT(run_.out, HasSubstr("poses   actions: 5 movements from 2,2.5,17.1887 "
                                    "(--initial-pose)\n"));
}

TEST_F(PosesFromMovement, odometryReducesAsWellAsRobotPoses) {
    writeLog(in_, interleaved(odometry_, clouds_));
    expectSameReduction(removedBy({"--initial-pose", first(), "--pose-sigma", sigmas}));
    EXPECT_THAT(run_.out, HasSubstr("ODOMETRY: 5 odometry readings from "));
}

TEST_F(PosesFromMovement, trajectoryReducesAsWellAsRobotPoses) {
    writeLog(in_, clouds_);
    writeFile(folder_ / "drive.tum", trajectory_);
    expectSameReduction(removedBy({"--trajectory", folder_ / "drive.tum", "--pose-sigma", sigmas}));
    EXPECT_THAT(run_.out, HasSubstr("poses   trajectory drive.tum: 5 poses\n"));
}

TEST_F(PosesFromMovement, lateClockIsSetRight) {
    for (const auto& localisation : localisations_) {
        localisation->timestamp +=
            std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::milliseconds(700));
    }
    writeLog(in_, interleaved(localisations_, clouds_));
    EXPECT_EQ(removedBy({"--pose-delay", "0.7"}), byRobotPoses_);
    EXPECT_THAT(run_.out, HasSubstr("LOCALIZATION: 5 robot poses, 0.7 s late"));
    EXPECT_EQ(reduce({"--strict", "--force"}).exitCode, 3) << "beyond pose.max_age_s";
}

TEST_F(PosesFromMovement, anotherClockIsWarnedOf) {
    const RunResult run = reduce({"--pose-delay", "-86400", "--force"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, AllOf(HasSubstr("warning: no pose is of the time of the scans"),
                               HasSubstr("1700086402.000")));
}

TEST_F(PosesFromMovement, movementThatIsNotFiniteKeepsTheRest) {
    mrpt::poses::CPosePDFGaussian nowhere;
    nowhere.mean.x(std::numeric_limits<double>::quiet_NaN());
    mrpt::obs::CActionRobotMovement2D movement;
    // What comes from odometry is stored as its reading, and worked out again when it is read.
    movement.estimationMethod = mrpt::obs::CActionRobotMovement2D::emScan2DMatching;
    movement.poseChange =
        mrpt::poses::CPosePDF::Ptr(std::make_shared<mrpt::poses::CPosePDFGaussian>(nowhere));
    actions_[3] = mrpt::obs::CActionCollection::Create();
    actions_[3]->insert(movement);
    writeLog(in_, actionsAndFrames());
    const auto report = folder_ / "report.json";
    const RunResult run =
        reduce({"--initial-pose", beforeFirst, "--report", report, "--strict", "--force"});
    EXPECT_EQ(run.exitCode, 3);
    const auto json = nlohmann::json::parse(readFile(report));
    EXPECT_EQ(json["totals"]["scans_not_reduced"], (nlohmann::json{{"pose_not_finite", 2}}));
    EXPECT_TRUE(json["scans"][2]["not_reduced"].is_null());
}

TEST_F(PosesFromMovement, placesAreNeededToBeginFrom) {
    std::filesystem::remove(out_);
    writeLog(in_, actionsAndFrames());
    expectRefusal(
        reduceArguments(), 2,
        AllOf(HasSubstr("actions: 5 movements"), HasSubstr("--initial-pose x,y,yaw_deg")));
    writeLog(in_, interleaved(odometry_, clouds_));
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr("ODOMETRY: 5 odometry readings"), HasSubstr("--initial-pose")));
    EXPECT_EQ(reduce({"--keep-going"}).exitCode, 0);
    EXPECT_EQ(entriesOf(out_).at(1).bytes, entriesOf(in_).at(1).bytes);
}

TEST_F(PosesFromMovement, initialPoseBesideRobotPosesIsRefused) {
    std::filesystem::remove(out_);
    expectRefusal(reduceArguments({"--initial-pose", "0,0,0"}), 1,
                  AllOf(HasSubstr("robot poses (LOCALIZATION)"), HasSubstr("leave it out")));
}

// Two real logs without a 3D scan: nothing to reduce, but nothing is lost.
TEST_F(PosesFromMovement, realLogsOfActionsAreCopied) {
    for (const char* name :
         {"localization_demo.rawlog", "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog"}) {
        in_ = std::string("/usr/share/mrpt/datasets/") + name;
        std::filesystem::remove(out_);
        expectRefusal(reduceArguments({"--initial-pose", "0,0,0"}), 2,
                      AllOf(HasSubstr("no 3D scan"), HasSubstr("CObservation2DRangeScan")));
        const RunResult run = reduce({"--initial-pose", "0,0,0", "--keep-going"});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto in = entriesOf(in_), out = entriesOf(out_);
        ASSERT_EQ(out.size(), in.size());
        for (size_t i = 0; i < in.size(); ++i) EXPECT_TRUE(out[i].bytes == in[i].bytes) << i;
    }
}

}  // namespace
