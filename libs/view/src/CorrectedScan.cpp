// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>
#include <offmap/view/CorrectedScan.h>

namespace offmap::view {

mrpt::poses::CPose3D foundSensor(const core::ScanColumn& column,
                                 const core::ReductionResult& result) {
    if (!result.alignment || result.notReduced) return column.sensor->sensorInMap;
    return core::correctedSensor(result.alignment->correction, column);
}

core::OrganizedScan correctedScan(const core::OrganizedScan& scan,
                                  const core::ReductionResult& result) {
    core::OrganizedScan out = scan;
    for (size_t c = 0; c < scan.columns.size(); ++c) {
        auto& sensor = out.columns[c].sensor;
        if (sensor) sensor->sensorInMap = foundSensor(scan.columns[c], result);
    }
    return out;
}

}  // namespace offmap::view
