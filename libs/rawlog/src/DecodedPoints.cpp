// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/DecodedPoints.h>

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace offmap::rawlog {

std::vector<mrpt::math::TPoint3Df> decodedPoints(const mrpt::obs::CObservation& obs,
                                                 const ScanClass& scanClass,
                                                 const SensorConfig& config) {
    const std::vector<uint8_t> all(scanClass.slotCount(obs), 1);
    const auto cloud = std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(
        scanClass.asPointCloud(obs, all, config));
    std::vector<mrpt::math::TPoint3Df> points;
    if (!cloud || !cloud->pointcloud) return points;
    const auto& x = cloud->pointcloud->getPointsBufferRef_x();
    const auto& y = cloud->pointcloud->getPointsBufferRef_y();
    const auto& z = cloud->pointcloud->getPointsBufferRef_z();
    ReturnCounts counts;
    points.reserve(x.size());
    for (size_t i = 0; i < x.size(); ++i) {
        const mrpt::math::TPoint3Df point(x[i], y[i], z[i]);
        if (countReturn(counts, point)) points.push_back(point);
    }
    return points;
}

}  // namespace offmap::rawlog
