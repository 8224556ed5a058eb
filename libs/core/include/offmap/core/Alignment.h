// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PoseCorrection.h>

namespace offmap::core {

/// How a scan's poses were conditioned on what the scan sees.
struct Alignment {
    PoseCorrection correction;
    double fittedShare = 0;     ///< [0, 1] of the sights that then lie on a wall
    double priorChiSquare = 0;  ///< of shift and turn under the stated covariance; 3 degrees
    double priorInflation = 1;  ///< what the stated standard deviations had to be multiplied by
    bool converged = false;

    /// Whether the stated covariance is too small for what the scan shows.
    bool contradictsPrior() const;
};

}  // namespace offmap::core
