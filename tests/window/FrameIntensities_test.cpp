// SPDX-License-Identifier: BSD-3-Clause
#include "FrameIntensities.h"

#include "MadeUpFrame.h"
#include "OfficeLogs.h"

#include <gmock/gmock.h>

namespace offmap::window {

TEST(FrameIntensities, thereIsOneForEachPoint) {
    const auto frame = test::officeFrame(0);
    const auto intensities = intensitiesOf(*frame);
    ASSERT_EQ(intensities.size(), frame->reduced.organized.scan.points.size());
    // The robot's clouds: 0.5 +- 0.03 a row, of which there are 15 to each side.
    EXPECT_THAT(intensities, testing::Each(testing::AllOf(testing::Ge(0.05F - 1e-6F),
                                                          testing::Le(0.95F + 1e-6F))));
    EXPECT_THAT(intensities, testing::Contains(testing::FloatNear(0.5F, 1e-6F)));
}

TEST(FrameIntensities, aSensorThatDoesNotTellHasNone) {
    live::LiveFrame frame = test::madeUpFrame();
    test::SimulatedRobot robot;
    frame.arrived.turn = {robot.imu()};
    EXPECT_THAT(intensitiesOf(frame), testing::IsEmpty());
    frame.arrived.turn = {robot.depthCamera()};
    frame.reduced.organized.scan = {};
    EXPECT_THAT(intensitiesOf(frame), testing::IsEmpty());
}

}  // namespace offmap::window
