// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/rawlog/PoseSource.h>

#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <optional>
#include <string>

namespace offmap::rawlog {

/// The vehicle's pose at a time, corrected by what a scan shows; none if the scan's poses were not
/// conditioned on it, if it was kept whole, or if there is no pose at that time.
std::optional<mrpt::poses::CPose3DPDFGaussian> refinedPose(const core::OrganizedScan& scan,
                                                           const core::ReductionResult& result,
                                                           const PoseSource& poses,
                                                           mrpt::Clock::time_point time);

mrpt::obs::CObservationRobotPose::Ptr robotPose(const mrpt::poses::CPose3DPDFGaussian& vehicleInMap,
                                                mrpt::Clock::time_point time,
                                                const std::string& label);

}  // namespace offmap::rawlog
