// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

#include <mrpt/obs/CObservation3DScene.h>

namespace offmap::test {
namespace {

using Inspect = ReduceFixture;

TEST_F(Inspect, holdsAPictureOfEachScan) {
    SimulatedRobot robot;
    Observations log{robot.localisation(), robot.cloud()};
    robot.wait(0.1);
    log.push_back(robot.cloud());
    writeLog(in_, log);
    const Path pictures = folder_ / "pictures.rawlog";
    const RunResult run = reduce({"--inspect", pictures});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Observations shown = observationsOf(pictures);
    ASSERT_EQ(shown.size(), 2U);
    for (const auto& entry : shown) {
        const auto picture = std::dynamic_pointer_cast<mrpt::obs::CObservation3DScene>(entry);
        ASSERT_TRUE(picture);
        EXPECT_TRUE(picture->scene->getByName("returns"));
    }
}

}  // namespace
}  // namespace offmap::test
