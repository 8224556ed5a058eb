// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace offmap::evaluation {

/// A 3D laser scanner: every azimuth is a column with a beam at every elevation.
struct Scanner {
    std::vector<double> azimuths;    ///< [rad] CCW from the sensor's x axis, in order of rotation
    std::vector<double> elevations;  ///< [rad] above the sensor's xy plane, ascending
    double maxRange;                 ///< [m] no return from further away
    double turnDuration;             ///< [s] from the first column to that of the next turn
};

/// The paper's: a 2D scanner of 180 degrees, turned about the vertical; 181 x 181 = 32,761 beams.
/// Columns run clockwise, as in the paper.
Scanner paperScanner();

/// Velodyne VLP-16: 16 rings from -15 to 15 degrees, 1800 columns.
Scanner vlp16();

/// A large scanner of today: 128 rings from -22.5 to 22.5 degrees, 2048 columns.
Scanner dense();

}  // namespace offmap::evaluation
