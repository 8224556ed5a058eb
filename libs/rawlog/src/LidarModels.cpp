// SPDX-License-Identifier: BSD-3-Clause
#include "FactoryCalibrations.h"

#include <offmap/rawlog/LidarModels.h>

#include <mrpt/core/bits_math.h>

namespace offmap::rawlog {

namespace {

// Names that CObservationRotatingScan::fromVelodyne() and fromScan2D() write.
constexpr std::string_view vlp16 = "VLP-16";
constexpr std::string_view hdl32 = "HDL-32E";
constexpr std::string_view scan2dPrefix = "2D_SCAN_";

std::vector<double> elevationsOf(const mrpt::obs::VelodyneCalibration& calibration) {
    std::vector<double> elevations;
    for (const auto& laser : calibration.laser_corrections) {
        elevations.push_back(mrpt::DEG2RAD(laser.verticalCorrection));
    }
    return elevations;
}

}  // namespace

bool isVelodyneModel(std::string_view lidarModel) {
    return lidarModel == vlp16 || lidarModel == hdl32;
}

std::vector<double> elevationsOfModel(std::string_view lidarModel) {
    static const std::vector<double> ofVlp16 = elevationsOf(factoryCalibrations().vlp16);
    static const std::vector<double> ofHdl32 = elevationsOf(factoryCalibrations().hdl32);
    if (lidarModel == vlp16) return ofVlp16;
    if (lidarModel == hdl32) return ofHdl32;
    if (lidarModel.starts_with(scan2dPrefix)) return {0};
    return {};
}

}  // namespace offmap::rawlog
