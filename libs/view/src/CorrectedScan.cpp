// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/CorrectedPose.h>
#include <offmap/view/CorrectedScan.h>

namespace offmap::view {

core::OrganizedScan correctedScan(const core::OrganizedScan& scan,
                                  const core::ReductionResult& result) {
    core::OrganizedScan out = scan;
    if (!result.alignment || result.notReduced) return out;
    for (size_t c = 0; c < scan.columns.size(); ++c) {
        auto& sensor = out.columns[c].sensor;
        if (!sensor) continue;
        sensor->sensorInMap = core::correctedSensor(result.alignment->correction, scan.columns[c]);
    }
    return out;
}

}  // namespace offmap::view
