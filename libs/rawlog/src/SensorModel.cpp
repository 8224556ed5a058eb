// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/SensorModel.h>
#include <offmap/rawlog/SweepFan.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

namespace offmap::rawlog {

namespace {

using namespace mrpt::obs;

SensorModel modelOf(const CObservationVelodyneScan& scan) {
    const size_t lasers = scan.calibration.laser_corrections.size();
    if (scan.scan_packets.empty()) return {"Velodyne", "no packets"};
    const auto& packet = scan.scan_packets.front();
    SensorModel model{"Velodyne", ""};
    if (lasers == 64) {  // whose packets hold laser status where others tell their model
        return {"HDL-64E", "64 lasers"};
    }
    if (packet.velodyne_model_ID == 0x21) {
        model.name = "HDL-32E";
    } else if (packet.velodyne_model_ID == 0x22) {
        model.name = "VLP-16";
    } else {
        model.name = fmt::format("Velodyne model 0x{:02x}", packet.velodyne_model_ID);
    }
    switch (packet.laser_return_mode) {
        case CObservationVelodyneScan::RETMODE_STRONGEST:
            model.details = "strongest return";
            break;
        case CObservationVelodyneScan::RETMODE_LAST:
            model.details = "last return";
            break;
        case CObservationVelodyneScan::RETMODE_DUAL:
            model.details = "dual return";
            break;
        default:
            model.details = "return mode not known";
    }
    return model;
}

SensorModel modelOf(const CObservation2DRangeScan& scan) {
    return {isVerticalFan(scan) ? "2D scanner, upright" : "2D scanner, level",
            fmt::format("{} rays over {:.0f} deg", scan.getScanSize(),
                        mrpt::RAD2DEG(static_cast<double>(scan.aperture)))};
}

SensorModel modelOf(const CObservation3DRangeScan& scan) {
    std::string details;
    if (scan.hasRangeImage) {
        details = fmt::format("{} x {} pixels", scan.cameraParams.ncols, scan.cameraParams.nrows);
    }
    if (scan.hasPoints3D) details += details.empty() ? "points" : ", points";
    if (scan.hasIntensityImage) details += details.empty() ? "image" : ", image";
    return {"depth camera", details};
}

SensorModel modelOf(const CObservationPointCloud& scan) {
    std::string details = "externally stored";
    if (!scan.isExternallyStored()) {
        details = scan.pointcloud ? classNameOf(*scan.pointcloud) : "no points";
    }
    return {"point cloud", details};
}

}  // namespace

SensorModel sensorModelOf(const CObservation& obs) {
    if (const auto* velodyne = dynamic_cast<const CObservationVelodyneScan*>(&obs)) {
        return modelOf(*velodyne);
    }
    if (const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&obs)) {
        return modelOf(*scan);
    }
    if (const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&obs)) {
        return modelOf(*scan);
    }
    if (const auto* scan = dynamic_cast<const CObservationPointCloud*>(&obs)) {
        return modelOf(*scan);
    }
    if (const auto* scan = dynamic_cast<const CObservationRotatingScan*>(&obs)) {
        return {scan->lidarModel,
                fmt::format("{} rows x {} columns", scan->rowCount, scan->columnCount)};
    }
    return {};
}

}  // namespace offmap::rawlog
