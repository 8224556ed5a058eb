// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PoseCorrection.h>

namespace offmap::core {

/// How a scan's poses were conditioned on what the scan sees.
struct Alignment {
    PoseCorrection correction;
    double fittedShare = 0;     ///< [0, 1] of the sights that then lie on a wall
    double throughShare = 0;    ///< [0, 1] of them that lie clearly behind one: seen through it
    double priorChiSquare = 0;  ///< of shift and turn under the stated covariance; 3 degrees
    double priorInflation = 1;  ///< what the stated standard deviations had to be multiplied by
    bool converged = false;

    /// Whether what the scan shows is what the map has there: most of what lies on walls or behind
    /// them lies on them. Things before walls tell nothing.
    /// \param minFittedShare [0, 1]
    bool fits(double minFittedShare) const;

    /// Whether the stated covariance is too small for what the scan shows.
    bool contradictsPrior() const;
};

}  // namespace offmap::core
