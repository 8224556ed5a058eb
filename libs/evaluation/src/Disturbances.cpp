// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Disturbances.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose3D;

void requireFactor(double x, const char* what) {
    if (!(x >= 0) || !std::isfinite(x)) {
        throw std::invalid_argument(std::string(what) + " must be >= 0");
    }
}

}  // namespace

std::vector<core::Wall> withMapError(std::vector<core::Wall> walls, double sigma,
                                     GaussianNoise& noise) {
    requireFactor(sigma, "the sigma of a map");
    std::map<std::pair<double, double>, TPoint2D> surveyed;
    for (core::Wall& wall : walls) {
        wall.sigma = sigma;
        for (TPoint2D* end : {&wall.line.point1, &wall.line.point2}) {
            const auto [known, isNew] = surveyed.try_emplace({end->x, end->y}, *end);
            if (isNew) {
                known->second.x += noise.next(sigma);
                known->second.y += noise.next(sigma);
            }
            *end = known->second;
        }
    }
    return walls;
}

core::SensorPose tilted(core::SensorPose sensor, double tilt, double direction) {
    const Eigen::Vector3d axis(-std::sin(direction), std::cos(direction), 0);
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(tilt, axis).toRotationMatrix();
    CPose3D lean;
    lean.setRotationMatrix(mrpt::math::CMatrixDouble33(rotation));
    sensor.sensorInMap = sensor.sensorInMap + lean;
    return sensor;
}

core::SensorPose withStatedSigma(core::SensorPose estimate, double factor) {
    requireFactor(factor, "the factor of a standard deviation");
    estimate.groundCovariance *= factor * factor;
    return estimate;
}

core::SensorPose misplaced(core::SensorPose sensor, double shift, double direction, double turn) {
    const CPose3D truth = sensor.sensorInMap;
    sensor.sensorInMap = CPose3D(0, 0, 0, turn, 0, 0) + truth;
    sensor.sensorInMap.x(truth.x() + shift * std::cos(direction));
    sensor.sensorInMap.y(truth.y() + shift * std::sin(direction));
    return sensor;
}

}  // namespace offmap::evaluation
