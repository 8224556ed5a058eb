// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/RangeImageScan.h>
#include <offmap/rawlog/RotatingGeometry.h>
#include <offmap/rawlog/RotatingScan.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SweepFan.h>
#include <offmap/rawlog/SweepScan.h>
#include <offmap/rawlog/VelodyneModel.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>

namespace offmap::rawlog {

const ScanClass* scanClassOf(const mrpt::obs::CObservation& obs, const SensorConfig& config) {
    static const VelodyneScan velodyne;
    static const PointCloudScan pointCloud;
    static const RotatingScan rotating;
    static const SweepScan sweep;
    static const RangeImageScan rangeImage;
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservationVelodyneScan*>(&obs)) {
        return unsupportedVelodyne(*scan) ? nullptr : &velodyne;
    }
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservationRotatingScan*>(&obs)) {
        return unsupportedRotatingScan(*scan, config) ? nullptr : &rotating;
    }
    if (dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&obs)) return &pointCloud;
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs)) {
        return isVerticalFan(*scan) ? &sweep : nullptr;
    }
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&obs)) {
        return unsupportedRangeImage(*scan) ? nullptr : &rangeImage;
    }
    return nullptr;
}

std::optional<std::string> unsupportedReason(const mrpt::obs::CObservation& obs,
                                             const SensorConfig& config) {
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservationVelodyneScan*>(&obs)) {
        return unsupportedVelodyne(*scan);
    }
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservationRotatingScan*>(&obs)) {
        return unsupportedRotatingScan(*scan, config);
    }
    if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&obs)) {
        return unsupportedRangeImage(*scan);
    }
    return {};
}

}  // namespace offmap::rawlog
