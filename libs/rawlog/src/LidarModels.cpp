// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LidarModels.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/VelodyneCalibration.h>

#include <string>

namespace offmap::rawlog {

namespace {

// Names that CObservationRotatingScan::fromVelodyne() and fromScan2D() write.
constexpr std::string_view vlp16 = "VLP-16";
constexpr std::string_view hdl32 = "HDL-32E";
constexpr std::string_view scan2dPrefix = "2D_SCAN_";

/// \param calibration the name by which MRPT keeps the factory's values
std::vector<double> factoryElevations(const std::string& calibration) {
    std::vector<double> elevations;
    for (const auto& laser :
         mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(calibration).laser_corrections) {
        elevations.push_back(mrpt::DEG2RAD(laser.verticalCorrection));
    }
    return elevations;
}

}  // namespace

bool isVelodyneModel(std::string_view lidarModel) {
    return lidarModel == vlp16 || lidarModel == hdl32;
}

std::vector<double> elevationsOfModel(std::string_view lidarModel) {
    static const std::vector<double> ofVlp16 = factoryElevations("VLP16");
    static const std::vector<double> ofHdl32 = factoryElevations("HDL32");
    if (lidarModel == vlp16) return ofVlp16;
    if (lidarModel == hdl32) return ofHdl32;
    if (lidarModel.starts_with(scan2dPrefix)) return {0};
    return {};
}

}  // namespace offmap::rawlog
