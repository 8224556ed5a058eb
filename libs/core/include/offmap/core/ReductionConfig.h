// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/bits_math.h>

#include <cstdint>
#include <limits>

namespace offmap::core {

/// Finding the vertical line segments of a column (section 3).
struct VerticalConfig {
    double maxPointToLine = 0.05;         ///< [m] split-and-merge tolerance
    double maxTilt = mrpt::DEG2RAD(5.0);  ///< [rad] eta: bound of the tilt gamma
    double maxGap = 0.5;                  ///< [m] between neighbouring returns of a segment
    double minLength = 0.3;               ///< [m] of the segment
    uint32_t minPoints = 4;               ///< returns on the segment
};

/// From a vertical segment to its interval of ground range (section 3.1).
struct GroundIntervalConfig {
    double maxMountingTilt = mrpt::DEG2RAD(1.5);  ///< [rad] gamma of eq. 4
};

enum class MatchingMethod : uint8_t { Paper, Probabilistic, Aligned };

/// Matching a ground interval to the map (section 3.2, 3.3).
struct MatchingConfig {
    MatchingMethod method = MatchingMethod::Aligned;
    double sigmaFactor = 2.0;                      ///< [-] sigmas that an uncertainty is taken as
    double maxRange = 100.0;                       ///< [m] walls further away are not looked for
    double maxPositionRadius = 0.5;                ///< [m] a larger position ellipse cannot be used
    double maxHeadingError = mrpt::DEG2RAD(15.0);  ///< [rad] nor can a heading less certain
};

/// Conditioning the pose on the scan, and the gate around walls (methods probabilistic, aligned).
struct AlignmentConfig {
    double sigmaRange = 0.02;               ///< [m] standard deviation of a single return's range
    double sigmaTilt = mrpt::DEG2RAD(1.2);  ///< [rad] of the sensor's lean about either axis
    double gate = 3.0;                      ///< [-] sigmas that a segment may stand off its wall
    double minFittedShare =
        0.5;  ///< [-] on walls, of the segments on or behind them; else all stay
};

/// Extending matched segments along their wall (section 3.3).
struct ExtensionConfig {
    bool enabled = true;
    double maxPointToLine = 0.05;  ///< [m] of a segment's centre to the horizontal line
    double minLength = 0.3;        ///< [m] of a horizontal line that may be extended
    uint32_t minSegments = 3;      ///< matched segments of a line that may be extended
    uint32_t maxColumnGap = 2;     ///< columns without a fitting segment that it crosses
    bool mapConsent = true;        ///< a wall of the map must stand where a segment is extended to
};

/// Removing single segments that nothing else stands beside (section 3.4).
struct OrphanConfig {
    bool remove = false;
    uint32_t neighbourColumns = 2;  ///< columns to either side that are looked at
    double maxDistance = 0.5;       ///< [m] a kept segment nearer than this is company
};

struct ReductionConfig {
    VerticalConfig vertical;
    GroundIntervalConfig groundInterval;
    MatchingConfig matching;
    AlignmentConfig alignment;
    ExtensionConfig extension;
    OrphanConfig orphan;

    /// \throw std::invalid_argument naming the field and its limits.
    void validate() const;
};

}  // namespace offmap::core
