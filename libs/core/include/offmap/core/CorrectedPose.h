// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PoseCorrection.h>

#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

namespace offmap::core {

/// Where a column's sensor stood, once the poses of its scan are corrected; at the height it had.
/// \pre the column has a pose
mrpt::poses::CPose3D correctedSensor(const PoseCorrection& correction, const ScanColumn& column);

/// Where the vehicle stood then: so that it carries the sensor, mounted as stated, to its corrected
/// place and lean. A lean that is the mounting's own thus becomes the vehicle's; the vehicle's own
/// height stays. The covariance is that of the correction; of the height, which no wall tells, 0.
/// \pre the column has a pose
mrpt::poses::CPose3DPDFGaussian correctedVehicle(const PoseCorrection& correction,
                                                 const ScanColumn& column);

}  // namespace offmap::core
