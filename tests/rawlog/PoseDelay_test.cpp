// SPDX-License-Identifier: BSD-3-Clause
#include "PoseChoiceFixture.h"

#include <gmock/gmock.h>

namespace offmap::rawlog {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PoseDelay : public PoseChoiceFixture {};

TEST_F(PoseDelay, lateStampsAreSetRight) {
    addRobotPoses("AMCL");  // a metre a second: the stamp 1.5 s tells where it was at 1.25 s
    PoseRequest request;
    request.delay = 0.25;
    const ChosenPoses late = choose(request);
    EXPECT_NEAR(xAt(late, 1.25), 11.5, 1e-6);  // ticks of 100 ns
    EXPECT_EQ(late.description, "AMCL: 3 robot poses, 0.25 s late");
    request.delay = -0.25;
    EXPECT_NEAR(xAt(choose(request), 1.25), 11, 1e-6);
}

TEST_F(PoseDelay, delayWorksForMovementsToo) {
    addOdometry("ODOMETRY");
    PoseRequest request = from({});
    request.delay = 0.5;
    EXPECT_NEAR(xAt(choose(request), 1), 3, 1e-6);
}

TEST_F(PoseDelay, delayAtTheEndsOfTimeIsHarmless) {
    survey_.poses["AMCL"] = {{mrpt::Clock::time_point::min(), {}, {}, {}},
                             {mrpt::Clock::time_point::max(), {}, {}, {}}};
    for (const double delay : {1e10, -1e10}) {
        PoseRequest request;
        request.delay = delay;
        EXPECT_EQ(choose(request).origin, PoseOrigin::RobotPoses);
    }
}

TEST_F(PoseDelay, posesOfAnotherClockAreWarnedOf) {
    addRobotPoses("AMCL");
    PoseRequest request;
    request.delay = 3600;
    EXPECT_THAT(choose(request).warning,
                AllOf(HasSubstr("1699996400.000 to 1699996402.000"),
                      HasSubstr("1700000000.000 to 1700000002.000"), HasSubstr("--pose-delay")));
    request.delay = 2 + config_.pose.maxAge;  // the last pose is just not too old for the first
    EXPECT_EQ(choose(request).warning, "");
}

}  // namespace
}  // namespace offmap::rawlog
