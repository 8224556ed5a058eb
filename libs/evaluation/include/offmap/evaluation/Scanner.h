// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace offmap::evaluation {

/// A 3D laser scanner: every azimuth is a column with a beam at every elevation.
struct Scanner {
    std::vector<double> azimuths;    ///< [rad] CCW from the sensor's x axis, in order of rotation
    std::vector<double> elevations;  ///< [rad] above the sensor's xy plane, ascending
    double maxRange;                 ///< [m] no return from further away
    double turnDuration;             ///< [s] from the first column to that of the next turn
    /// [rad] CCW from a column's azimuth to that of its rings, which fire one after the other; one
    /// per elevation, or none at all
    std::vector<double> ringAzimuths = {};
    /// Whether the beams go through the pixels of a flat image: the elevations are those straight
    /// ahead, to the side the same rows are seen lower.
    bool isFlatImage = false;
};

/// Where a beam goes, in the sensor's frame.
struct BeamAngles {
    double azimuth;    ///< [rad] CCW from the x axis
    double elevation;  ///< [rad] above the xy plane
};

/// \param column, ring indices into azimuths and elevations
BeamAngles beamAngles(const Scanner& scanner, size_t column, size_t ring);

/// The paper's: a 2D scanner of 180 degrees, turned about the vertical; 181 x 181 = 32,761 beams.
/// Columns run clockwise, as in the paper.
Scanner paperScanner();

/// Velodyne VLP-16: 16 rings from -15 to 15 degrees, 1800 columns.
Scanner vlp16();

/// A large scanner of today: 128 rings from -22.5 to 22.5 degrees, 2048 columns.
Scanner dense();

/// VLP-16 as it fires: ring after ring, each further round, two firings to a block of its packets,
/// 75 packets to a turn.
Scanner vlp16Firings();

/// A depth camera of 320 x 240 pixels that sees 60 x 47 degrees, all at once. Its columns run from
/// left to right.
Scanner depthCamera();

}  // namespace offmap::evaluation
