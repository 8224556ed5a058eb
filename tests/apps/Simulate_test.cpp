// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateFixture.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace offmap::test;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRobotPose;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

using Simulate = SimulateFixture;

TEST_F(Simulate, writesLogMapsAndTruth) {
    const RunResult run = simulate("office_room", {"--scans", "2"});
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(sim_)) {
        names.push_back(file.path().filename());
        EXPECT_THAT(run.out, HasSubstr(file.path().string()));
    }
    EXPECT_THAT(
        names, UnorderedElementsAre("scans.rawlog", "map.lines", "map.gridmap.gz", "truth.csv.gz"));
    EXPECT_EQ(logged<CObservationPointCloud>().size(), 2U);
    EXPECT_EQ(truth().size(), 2U);
}

TEST_F(Simulate, sameOptionsGiveTheSameBytes) {
    const Arguments options{"--scans", "2",   "--scanner",     "vlp16", "--seed",  "5",
                            "--tilt",  "0.5", "--angle-noise", "0.1",   "--speed", "0.5"};
    simulate("random_scene", options);
    std::map<std::string, std::string> first;
    for (const auto& file : std::filesystem::directory_iterator(sim_)) {
        first[file.path()] = readFile(file.path());
    }
    Arguments again = options;
    again.push_back("--force");
    simulate("random_scene", again);
    for (const auto& [file, bytes] : first) EXPECT_EQ(readFile(file) == bytes, true) << file;

    again[5] = "6";
    simulate("random_scene", again);
    for (const auto& [file, bytes] : first) EXPECT_EQ(readFile(file) == bytes, false) << file;
}

TEST_F(Simulate, posesHaveTheErrorsAndTheSigmasThatWereAskedFor) {
    simulate("office_room", {"--scans", "1", "--pose-sigma", "0,0"});
    const auto exact = logged<CObservationRobotPose>();
    ASSERT_FALSE(exact.empty());
    EXPECT_EQ(exact.front()->pose.mean.asString(),
              "[2.000000 2.500000 0.000000 0.000000 0.000000 "
              "0.000000]");

    simulate("office_room",
             {"--scans", "1", "--pose-sigma", "0.1,2", "--stated-factor", "0.5", "--force"});
    const auto off = logged<CObservationRobotPose>();
    ASSERT_EQ(off.size(), exact.size());
    for (size_t i = 0; i < off.size(); ++i) {
        const auto& cov = off[i]->pose.cov;
        EXPECT_DOUBLE_EQ(cov(0, 0), 0.05 * 0.05);
        EXPECT_DOUBLE_EQ(cov(1, 1), 0.05 * 0.05);
        EXPECT_DOUBLE_EQ(cov(3, 3), std::pow(mrpt::DEG2RAD(1.0), 2));
        const auto error = off[i]->pose.mean - off[0]->pose.mean;
        EXPECT_NEAR(error.norm(), 0, 1e-12) << "the error stays during a scan";
    }
    const double shift = off[0]->pose.mean.distanceTo(exact[0]->pose.mean);
    EXPECT_GT(shift, 0.001);
    EXPECT_LT(shift, 0.5) << "5 sigma";
}

TEST_F(Simulate, scannerLeansAsMuchAsAskedFor) {
    simulate("office_room", {"--scans", "1", "--range-noise", "0", "--tilt", "4"});
    const auto cloud = logged<CObservationPointCloud>().at(0);
    EXPECT_EQ(cloud->sensorPose.roll(), 0) << "the log does not know";
    // A point of the floor, h below the sensor, has z cos t = -h + r sin t cos(azimuth).
    const double tilt = mrpt::DEG2RAD(4.0), h = cloud->sensorPose.z();
    double steepest = 0;
    const auto known = truth();
    for (const auto& point : known.at(0).points) {
        if (point.kind != offmap::evaluation::SurfaceKind::Floor) continue;
        const auto p = point.point.cast<double>();
        const double range = std::hypot(p.x, p.y);
        if (range > 1) steepest = std::max(steepest, (p.z * std::cos(tilt) + h) / range);
    }
    // The nearest column is up to half a step of 2 degrees off that azimuth: cos(1 deg).
    EXPECT_NEAR(steepest, std::sin(tilt), 2e-4 * std::sin(tilt) + 1e-6);
}

TEST_F(Simulate, mapErrorShiftsTheWallsAndIsTold) {
    simulate("office_room", {"--scans", "1", "--map-error", "0"});
    const std::string exact = readFile(sim_ / "map.lines");
    EXPECT_THAT(exact, HasSubstr("0.0000 0.0000  8.0000 0.0000  0.0000\n"));
    simulate("office_room", {"--scans", "1", "--map-error", "0.05", "--force"});
    const std::string off = readFile(sim_ / "map.lines");
    EXPECT_THAT(off, HasSubstr("  0.0500\n"));
    EXPECT_THAT(off, testing::Not(HasSubstr("8.0000 0.0000")));
}

TEST_F(Simulate, gridmapShowsTheWalls) {
    simulate("office_room", {"--scans", "1", "--map-error", "0"});
    mrpt::io::CFileGZInputStream in((sim_ / "map.gridmap.gz").string());
    auto archive = mrpt::serialization::archiveFrom(in);
    const auto grid =
        std::dynamic_pointer_cast<mrpt::maps::COccupancyGridMap2D>(archive.ReadObject());
    ASSERT_TRUE(grid);
    // MRPT holds a probability as eight bits of its log-odds, never 0 or 1. The walls stand on the
    // border of two cells.
    const auto isWall = [&](float x, float y) {
        constexpr float beside = 0.02F;
        return std::min(grid->getPos(x - beside, y - beside),
                        grid->getPos(x + beside, y + beside)) < 0.01F;
    };
    EXPECT_TRUE(isWall(4, 0));
    EXPECT_TRUE(isWall(0, 3));
    EXPECT_TRUE(isWall(5.4F, 5)) << "the map knows no open door";
    EXPECT_GT(grid->getPos(4.5F, 2), 0.99) << "nor the person";
    EXPECT_GT(grid->getPos(2, 2.5F), 0.99);
}

TEST_F(Simulate, movementThatTheLogDoesNotKnowCostsWalls) {
    const auto removed = [&](const Arguments& more) {
        Arguments all{"--scans", "2", "--yaw-rate", "20", "--pose-sigma", "0.01,0.1", "--force"};
        all.insert(all.end(), more.begin(), more.end());
        const RunResult run = simulate("office_room", all);
        EXPECT_EQ(
            follow(run, "reduce", "--force --report " + (folder_ / "r.json").string()).exitCode, 0);
        return json(folder_ / "r.json")["totals"]["points_removed"].get<double>();
    };
    for (const std::string scanClass : {"pointcloud", "rotating", "sweep"}) {
        const double known = removed({"--class", scanClass});
        // In 2.4 s the robot turns 48 degrees: half-way round, walls are metres off.
        EXPECT_LT(removed({"--class", scanClass, "--no-compensation"}), 0.8 * known) << scanClass;
    }
}

}  // namespace
