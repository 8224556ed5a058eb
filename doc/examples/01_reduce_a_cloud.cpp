// SPDX-License-Identifier: BSD-3-Clause
// A cloud of your own, a pose of your own, no file: what a node of a navigation stack does.
#include <offmap/rawlog/CloudReducer.h>

#include <mrpt/poses/CPosePDFGaussian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

enum Surface { onWall, onPerson, onFloor };
constexpr std::array names{"wall", "person", "floor"};

/// Whatever your points are, if they have x, y, z [m]. `surface` is for the count at the end only.
struct MyPoint {
    float x, y, z;
    Surface surface;
};

constexpr double sensorHeight = 1.2;  // [m] above the floor

/// What one beam meets in a room of 6 x 4 m. The sensor stands in its middle, and 1.2 m in front of
/// it a person, a cylinder 0.5 m across and 1.75 m high.
MyPoint meet(double azimuth, double elevation) {
    const double ux = std::cos(azimuth), uy = std::sin(azimuth), slope = std::tan(elevation);
    double range = std::min(3 / std::abs(ux), 2 / std::abs(uy));  // [m] on the ground
    Surface surface = onWall;
    const double along = ux * 1.2, aside = uy * 1.2;  // of the person's axis, from the beam
    if (along > 0 && std::abs(aside) < 0.25) {
        const double toPerson = along - std::sqrt(0.25 * 0.25 - aside * aside);
        if (sensorHeight + toPerson * slope < 1.75) range = toPerson, surface = onPerson;
    }
    if (range * -slope > sensorHeight) range = sensorHeight / -slope, surface = onFloor;
    return {static_cast<float>(range * ux), static_cast<float>(range * uy),
            static_cast<float>(range * slope), surface};
}

}  // namespace

int main() {
    std::vector<MyPoint> cloud;
    for (double azimuth = -179.5; azimuth < 180; azimuth += 1) {  // [deg]
        for (double elevation = -40; elevation <= 40; elevation += 1) {
            cloud.push_back(meet(azimuth * M_PI / 180, elevation * M_PI / 180));
        }
    }

    // The map: four walls, from corner to corner in top view. The person is not on it.
    const offmap::core::LineMap map(
        {{{{-3, -2}, {3, -2}}}, {{{3, -2}, {3, 2}}}, {{{3, 2}, {-3, 2}}}, {{{-3, 2}, {-3, -2}}}});

    // The pose that a localisation gave: 2 cm and a quarter of a degree wrong, as it may be with
    // sigmas of 3 cm and half a degree.
    mrpt::math::CMatrixDouble33 covariance;
    covariance(0, 0) = covariance(1, 1) = 0.03 * 0.03;   // [m^2]
    covariance(2, 2) = std::pow(0.5 * M_PI / 180.0, 2);  // [rad^2]
    const mrpt::poses::CPosePDFGaussian pose({0.02, 0, 0.25 * M_PI / 180.0}, covariance);
    const mrpt::poses::CPose3D sensorInVehicle(0, 0, sensorHeight, 0, 0, 0);

    // The reduction: one label per point. Keep the reducer for the next cloud.
    offmap::rawlog::CloudReducer reducer(map);
    const auto& labels = reducer.reduce(offmap::rawlog::xyzOf(cloud),
                                        mrpt::poses::CPose3DPDFGaussian(pose), sensorInVehicle);

    std::array<int, 3> points{}, removed{};
    for (size_t i = 0; i < cloud.size(); ++i) {
        ++points.at(cloud[i].surface);
        removed.at(cloud[i].surface) += offmap::core::isRemoved(labels[i]);
    }
    for (const Surface s : {onWall, onPerson, onFloor}) {
        std::printf("%-8s %6d points, %6d removed\n", names.at(s), points.at(s), removed.at(s));
    }
}
