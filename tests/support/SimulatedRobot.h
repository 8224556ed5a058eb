// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DepthCameraMaker.h"
#include "RotatingMaker.h"
#include "SweepMaker.h"
#include "VelodyneMaker.h"

#include <offmap/evaluation/GaussianNoise.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/World.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace offmap::test {

using Observations = std::vector<mrpt::obs::CObservation::Ptr>;

/// A robot in the office of evaluation::officeRoom(), and what its sensors record.
class SimulatedRobot {
 public:
    explicit SimulatedRobot(uint64_t seed = 1) : noise_(seed) {}

    mrpt::poses::CPose3D pose{2.0, 2.5, 0, 0.3, 0, 0};  ///< in the map, where it truly is
    double yawRate = 0;  ///< [rad/s] at which it turns on the spot, also while a sensor scans
    mrpt::Clock::time_point now = mrpt::Clock::fromDouble(1.7e9);

    void wait(double seconds) {
        pose = turned(pose, seconds);
        now += std::chrono::duration_cast<mrpt::Clock::duration>(
            std::chrono::duration<double>(seconds));
    }

    /// The true pose, with a covariance of 2 cm and 0.5 degrees.
    auto localisation(const std::string& label = "LOCALIZATION") const {
        auto obs = stamped<mrpt::obs::CObservationRobotPose>(label);
        obs->pose.mean = pose;
        obs->pose.cov.setZero();
        for (int i = 0; i < 6; ++i) {
            const double sigma = i < 3 ? 0.02 : mrpt::DEG2RAD(0.5);
            obs->pose.cov(i, i) = sigma * sigma;
        }
        return obs;
    }

    /// \param packets of 24 columns; 75 make a whole turn
    auto vlp16(size_t packets = 75, const std::string& label = "VLP16") {
        return velodyne(vlp16Plan, "VLP16", packets, label);
    }

    /// In every fifth pair of blocks, the returns differ. \param packets 150 make a whole turn
    auto vlp16Dual(size_t packets = 150, const std::string& label = "VLP16") {
        return velodyne(vlp16DualPlan, "VLP16", packets, label);
    }

    /// \param packets of 12 columns; 180 make a whole turn
    auto hdl32(size_t packets = 180, const std::string& label = "HDL32") {
        return velodyne(hdl32Plan, "HDL32", packets, label);
    }

    /// \param packets of 6 columns; 348 make a whole turn
    auto hdl64(size_t packets = 348, const std::string& label = "HDL64") {
        return velodyne(hdl64Plan, "", packets, label);
    }

    /// Columns of 31 points, 4 degrees apart, with intensity.
    auto cloud(const std::string& label = "CLOUD", size_t columns = 120) {
        auto obs = stamped<mrpt::obs::CObservationPointCloud>(label);
        obs->sensorPose = {-0.2, 0.1, 1.3, 0.5, 0, 0};
        auto points = mrpt::maps::CPointsMapXYZI::Create();
        for (size_t column = 0; column < columns; ++column) {
            const double azimuth = mrpt::DEG2RAD(degreesOf(column, columns));
            for (int row = -15; row <= 15; ++row) {
                const double up = mrpt::DEG2RAD(4.0 * row), across = std::cos(up);
                const mrpt::math::TVector3D beam{across * std::cos(azimuth),
                                                 across * std::sin(azimuth), std::sin(up)};
                const auto hit = rangeAlong(obs->sensorPose, beam);
                if (hit <= 0) continue;
                const float intensity = 0.5F + 0.03F * static_cast<float>(row);
                points->insertPointRGB(static_cast<float>(hit * beam.x),
                                       static_cast<float>(hit * beam.y),
                                       static_cast<float>(hit * beam.z), intensity, 0, 0);
            }
        }
        obs->pointcloud = points;
        return obs;
    }

    /// 32 rows, 3 degrees apart (rotatingElevations()), with intensity.
    auto rotatingScan(const std::string& label = "ROTATING", uint16_t columns = 360) {
        const mrpt::poses::CPose3D mount{0.2, -0.1, 1.2, 0.4, 0, 0};
        const auto obs =
            rotatingScanOf([&](const auto& beam) { return rangeAlong(mount, beam); }, columns);
        obs->sensorLabel = label;
        obs->timestamp = now;
        obs->sensorPose = mount;
        return obs;
    }

    /// One turn of a 2D scanner on its side, in 0.8 s.
    Observations sweep(size_t columns = 90, const std::string& label = "SWEEP") {
        Observations fans;
        for (size_t column = 0; column < columns; ++column) {
            const auto mount = fanPose(degreesOf(column, columns), 0, true, {0.05, 0, 0.9});
            const auto fan = fanIn(
                [this](const auto& from, const auto& direction) {
                    return rangeAlong(mrpt::poses::CPose3D(from.x, from.y, from.z, 0, 0, 0),
                                      direction);
                },
                mount);
            fan->sensorLabel = label;
            fan->timestamp = now;
            fans.push_back(fan);
            wait(0.8 / static_cast<double>(columns));
        }
        return fans;
    }

    /// Sees 60 x 47 degrees straight ahead, on its side if rolled by 90 degrees; points included.
    auto depthCamera(const std::string& label = "DEPTH", double rollDegrees = 0) {
        const auto obs = emptyDepthImage();
        obs->sensorLabel = label;
        obs->timestamp = now;
        obs->sensorPose = {0.2, 0, 1.2, 0, 0, mrpt::DEG2RAD(rollDegrees)};
        fillDepths(*obs, [&](const mrpt::math::TVector3D& direction) {
            return rangeAlong(obs->sensorPose, direction / direction.norm()) / direction.norm();
        });
        storePoints(*obs);
        return obs;
    }

    auto horizontalScan() const {
        auto obs = stamped<mrpt::obs::CObservation2DRangeScan>("FRONT_LASER");
        obs->aperture = static_cast<float>(M_PI);
        obs->resizeScanAndAssign(181, 2.5F, true);
        return obs;
    }

    auto odometry() const {
        auto obs = stamped<mrpt::obs::CObservationOdometry>("ODOMETRY");
        obs->odometry = mrpt::poses::CPose2D(0.5, -0.25, 0.125);
        return obs;
    }

    auto imu() const {
        auto obs = stamped<mrpt::obs::CObservationIMU>("IMU");
        obs->set(mrpt::obs::IMU_Z_ACC, 9.81);
        return obs;
    }

    auto comment(const std::string& text) const {
        auto obs = stamped<mrpt::obs::CObservationComment>("");
        obs->text = text;
        return obs;
    }

 private:
    static double degreesOf(size_t column, size_t columns) {
        return 360.0 * static_cast<double>(column) / static_cast<double>(columns);
    }

    template <class T>
    std::shared_ptr<T> stamped(const std::string& label) const {
        auto obs = std::make_shared<T>();
        obs->sensorLabel = label;
        obs->timestamp = now;
        return obs;
    }

    std::shared_ptr<mrpt::obs::CObservationVelodyneScan> velodyne(const VelodynePlan& plan,
                                                                  const std::string& calibration,
                                                                  size_t packets,
                                                                  const std::string& label) {
        auto obs = stamped<mrpt::obs::CObservationVelodyneScan>(label);
        obs->sensorPose = {0.1, 0, 1.1, 0, 0, 0};
        obs->calibration =
            calibration.empty()
                ? hdl64Calibration()
                : mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(calibration);
        const auto start = pose;
        fireVelodyne(*obs, plan, packets, [&](double seconds, const auto& beam) {
            pose = turned(start, seconds);
            return rangeAlong(obs->sensorPose, beam);
        });
        pose = start;
        return obs;
    }

    mrpt::poses::CPose3D turned(const mrpt::poses::CPose3D& from, double seconds) const {
        if (yawRate == 0) return from;
        return from + mrpt::poses::CPose3D(0, 0, 0, yawRate * seconds, 0, 0);
    }

    /// [m] with a noise of 5 mm; 0 for no return. \param beam unit vector in the sensor's frame
    double rangeAlong(const mrpt::poses::CPose3D& mount, const mrpt::math::TVector3D& beam) {
        const auto sensor = pose + mount;
        const auto hit = world_.castRay(sensor.translation(), sensor.rotateVector(beam), maxRange);
        return hit ? std::max(0.0, hit->range + noise_.next(0.005)) : 0;
    }

    static constexpr double maxRange = 30;  // [m]

    const evaluation::World world_ = evaluation::officeRoom();
    evaluation::GaussianNoise noise_;
};

/// The text map of the robot's office, as it is drawn.
inline std::string officeMap() {
    std::string text = "# x1 y1 x2 y2 sigma [m]\n";
    for (const core::Wall& wall : mapOf(evaluation::officeRoom())) {
        for (const double value :
             {wall.line.point1.x, wall.line.point1.y, wall.line.point2.x, wall.line.point2.y}) {
            text += std::to_string(value) + " ";
        }
        text += "0.02\n";
    }
    return text;
}

}  // namespace offmap::test
