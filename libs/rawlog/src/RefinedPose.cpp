// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/RefinedPose.h>

#include <algorithm>

namespace offmap::rawlog {

std::optional<mrpt::poses::CPose3DPDFGaussian> refinedPose(const core::OrganizedScan& scan,
                                                           const core::ReductionResult& result,
                                                           const PoseSource& poses,
                                                           mrpt::Clock::time_point time) {
    if (!result.alignment || result.notReduced) return std::nullopt;
    const auto placed = std::ranges::find_if(
        scan.columns, [](const core::ScanColumn& column) { return column.sensor.has_value(); });
    const PoseLookup vehicle = poses.at(time);
    if (placed == scan.columns.end() || !vehicle.vehicleInMap) return std::nullopt;
    // The correction is that of all columns: also of one taken just then.
    core::ScanColumn column;
    placeColumn(column, vehicle, mrpt::poses::CPose3D(placed->sensorInVehicle));
    return core::correctedVehicle(result.alignment->correction, column);
}

mrpt::obs::CObservationRobotPose::Ptr robotPose(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap,
                                                mrpt::Clock::time_point time,
                                                const std::string& label) {
    auto obs = mrpt::obs::CObservationRobotPose::Create();
    obs->timestamp = time;
    obs->sensorLabel = label;
    obs->pose = vehicleInMap;
    return obs;
}

}  // namespace offmap::rawlog
