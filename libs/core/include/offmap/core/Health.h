// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionResult.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace offmap::core {

/// Why the result of a scan is in doubt.
enum class Suspicion : uint8_t {
    DoesNotFit,        ///< what it shows fits no place that the pose allows; it was kept whole
    PoseContradicted,  ///< it fits a place that the pose's covariance hardly allows
    FewMatches,        ///< little of what it shows where the map has walls was found to be one
    Biased,            ///< walls are found, but all of them nearer or further than the map says
};
inline constexpr size_t suspicionCount = 4;

/// Stable snake_case name, as in reports: "pose_does_not_fit", ...
std::string_view toString(Suspicion suspicion);

/// How a scan's poses went together with what it shows.
struct PoseFit {
    double shift = 0;           ///< [m] that the sensor was moved by on the ground
    double turn = 0;            ///< [rad] that the heading was turned by
    double fittedShare = 0;     ///< see Alignment, as the following
    double priorChiSquare = 0;  ///< 3 degrees of freedom
    double priorInflation = 1;
};

/// How well scan, pose and map go together.
struct Health {
    /// [0, 1] Removed, of the returns on those vertical segments that were matched to a wall or
    /// whose ray meets one; none without such segments.
    std::optional<double> matchedShare;
    /// [m] Measured minus predicted ground range, the median of the segments matched by their ray;
    /// none without such segments.
    std::optional<double> residualBias;
    std::optional<PoseFit> fit;  ///< with methods that condition the poses on the scan
    std::optional<Suspicion> suspect;
};

Health healthOf(const ReductionResult& result);

}  // namespace offmap::core
