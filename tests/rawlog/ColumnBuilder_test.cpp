// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;

TEST(ColumnBuilder, uprightMountingTurnsAzimuthsAsOneThatHardlyLeans) {
    for (const double yaw : {0.0, 1.0, 3.0, -3.0}) {
        for (double azimuth = -3.1; azimuth < 3.2; azimuth += 0.3) {
            const double upright = azimuthInVehicle(azimuth, CPose3D(1, 2, 3, yaw, 0, 0));
            const double leaning = azimuthInVehicle(azimuth, CPose3D(1, 2, 3, yaw, 1e-7, 1e-7));
            EXPECT_GE(upright, -M_PI);
            EXPECT_LE(upright, M_PI);
            // A lean of 1e-7 rad turns an azimuth by its square.
            EXPECT_NEAR(mrpt::math::wrapToPi(upright - leaning), 0, 1e-13);
        }
    }
}

TEST(ColumnBuilder, mountingUpsideDownMirrorsAzimuths) {
    EXPECT_NEAR(azimuthInVehicle(0.5, CPose3D(0, 0, 0, 0, 0, M_PI)), -0.5, 1e-12);
}

}  // namespace
}  // namespace offmap::rawlog
