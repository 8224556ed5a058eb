// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace offmap::rawlog {

/// Points as an observation of the same time, label and sensor pose as the one they come from.
inline mrpt::obs::CObservationPointCloud::Ptr cloudLike(const mrpt::obs::CObservation& obs,
                                                        const mrpt::maps::CPointsMap::Ptr& points) {
    auto out = mrpt::obs::CObservationPointCloud::Create();
    out->timestamp = obs.timestamp;
    out->sensorLabel = obs.sensorLabel;
    obs.getSensorPose(out->sensorPose);
    out->pointcloud = points;
    return out;
}

}  // namespace offmap::rawlog
