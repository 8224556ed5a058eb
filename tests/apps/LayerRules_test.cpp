// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <offmap/evaluation/World.h>
#include <offmap/maps/SvgMapWriter.h>

#include <mrpt/core/bits_math.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace offmap::test;
using offmap::core::Wall;
using testing::HasSubstr;

constexpr double counterX = 5;  // [m] where its face stands; the scanner is at x = 2

/// A room of 8 m x 5 m, a counter 1 m high, and a cupboard above it, flush with its face.
offmap::evaluation::World shop() {
    offmap::evaluation::World world;
    world.addFloor();
    world.addCeiling(2.8);
    const mrpt::math::TPoint2D corners[] = {{0, 0}, {8, 0}, {8, 5}, {0, 5}, {0, 0}};
    for (int i = 0; i < 4; ++i) world.addMappedPanel({{corners[i], corners[i + 1]}, {0, 2.8}});
    const mrpt::math::TSegment2D face{{counterX, 1}, {counterX, 4}};
    world.addObject(offmap::evaluation::Panel{face, {0, 1}});
    world.addObject(offmap::evaluation::Panel{face, {1.6, 2.4}});
    return world;
}

class LayerRules : public ReduceFixture {
 protected:
    LayerRules() {
        map_ = folder_ / "shop.svg";
        std::vector<Wall> walls = mapOf(shop());
        std::vector<std::string> layers(walls.size(), "WALLS");
        Wall counter;
        counter.line = {{counterX, 1}, {counterX, 4}};
        walls.push_back(counter);
        layers.emplace_back("COUNTER");
        writeFile(map_, offmap::maps::svgMapOf(walls, layers));

        SimulatedRobot robot;
        robot.pose = {2, 2.5, 0, 0, 0, 0};
        Observations log{robot.localisation()};
        robot.wait(0.1);
        const auto cloud = robot.cloud();
        scanShop(*cloud, robot.pose);
        log.push_back(cloud);
        robot.wait(0.1);
        log.push_back(robot.localisation());
        writeLog(in_, log);
    }

    /// Columns every 2 degrees, of beams every 2 degrees.
    static void scanShop(mrpt::obs::CObservationPointCloud& cloud,
                         const mrpt::poses::CPose3D& robot) {
        const auto world = shop();
        const auto sensor = robot + cloud.sensorPose;
        cloud.pointcloud->clear();
        for (int column = 0; column < 180; ++column) {
            for (int row = -30; row <= 30; ++row) {
                const double azimuth = mrpt::DEG2RAD(2.0 * column), up = mrpt::DEG2RAD(2.0 * row);
                const mrpt::math::TVector3D beam{std::cos(up) * std::cos(azimuth),
                                                 std::cos(up) * std::sin(azimuth), std::sin(up)};
                const auto hit = world.castRay(sensor.translation(), sensor.rotateVector(beam), 30);
                if (!hit) continue;
                const auto point = beam * hit->range;
                cloud.pointcloud->insertPoint(static_cast<float>(point.x),
                                              static_cast<float>(point.y),
                                              static_cast<float>(point.z));
            }
        }
    }

    struct Removed {
        double counter, cupboard;  ///< shares of their returns
    };

    Removed reduceShop(const Arguments& more) {
        Arguments arguments{"--force"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = reduce(arguments);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const auto before = returnsAt(in_), after = returnsAt(out_);
        EXPECT_GT(before.counter, 150);
        EXPECT_GT(before.cupboard, 150);
        return {1 - after.counter / before.counter, 1 - after.cupboard / before.cupboard};
    }

    /// How many stand on the face of either.
    static Removed returnsAt(const Path& log) {
        Removed count{0, 0};
        const auto obs = observationsOf(log).at(1);
        const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
        for (const Return& hit : returnsOf(cloud)) {
            const auto inVehicle = cloud.sensorPose.composePoint({hit[0], hit[1], hit[2]});
            if (std::abs(inVehicle.x + 2 - counterX) > 0.01 || inVehicle.z < 0.05) continue;
            if (inVehicle.z < 1) ++count.counter;
            if (inVehicle.z > 1.55) ++count.cupboard;
        }
        return count;
    }
};

}  // namespace

TEST_F(LayerRules, counterIsAWallOnlyBelowItsTop) {
    const Removed without = reduceShop({});
    EXPECT_GT(without.counter, 0.9);
    EXPECT_GT(without.cupboard, 0.9) << "else the rule would prove nothing";
    const Removed with = reduceShop({"--set", "layers.COUNTER.z_max_m=1"});
    EXPECT_GT(with.counter, 0.9);
    EXPECT_EQ(with.cupboard, 0);
}

TEST_F(LayerRules, layerDeclaredAbsentIsNoWall) {
    writeFile(folder_ / "own.yaml", "layers: {'count*': {present: false}}\n");
    const Removed with =
        reduceShop({"--config", folder_ / "own.yaml", "--report", folder_ / "r.json"});
    EXPECT_EQ(with.counter, 0);
    EXPECT_EQ(with.cupboard, 0);
    const auto report = nlohmann::json::parse(readFile(folder_ / "r.json"));
    EXPECT_EQ(report["parameters"]["layers.count*.present"], "false");
}

TEST_F(LayerRules, ruleThatFitsNothingIsWarnedOf) {
    const RunResult run = reduce({"--set", "layers.BENCH.z_max_m=1"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err,
                HasSubstr("layers.BENCH fits no layer of the map; there are: WALLS, COUNTER"));
}

TEST_F(LayerRules, wrongOneIsRefused) {
    expectRefusal(reduceArguments({"--set", "layers.COUNTER.z_mx_m=1"}), 1,
                  HasSubstr("did you mean z_max_m?"));
    expectRefusal(reduceArguments({"--set", "layers.C.z_min_m=2", "--set", "layers.C.z_max_m=1"}),
                  1, HasSubstr("layers.C: z_min_m 2 is above z_max_m 1"));
}
