// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionConfig.h>
#include <offmap/rawlog/Movement.h>
#include <offmap/rawlog/PoseSource.h>

#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <map>
#include <optional>

namespace offmap::rawlog {

/// How well a source of poses serves the 3D observations of a log, and how the vehicle moved
/// according to it.
class PoseCoverage {
 public:
    /// How the errors of poses hang together. Those of a localisation are new with every pose and
    /// look like movement; those of composed movements grow, but neighbours have them in common.
    enum class Errors : uint8_t { Independent, Common };

    /// \param poses must outlive it
    PoseCoverage(const PoseSource& poses, const core::MatchingConfig& config,
                 Errors errors = Errors::Independent)
        : poses_(poses), config_(config), errors_(errors) {}

    /// Asks for the pose of a 3D observation.
    void add(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& sensorInVehicle);
    /// Follows the vehicle; to be called for the times of all observations, in their order.
    void follow(mrpt::Clock::time_point time);

    uint64_t observations() const { return observations_; }
    uint64_t covered() const { return covered_; }  ///< have a pose that reduction would use
    /// How many of the others have none for which reason.
    const std::map<core::PoseFault, uint64_t>& faults() const { return faults_; }
    /// Of `observations`, nought to one; 0 without any.
    double share() const;
    const Movement& movement() const { return movement_; }

 private:
    const PoseSource& poses_;
    core::MatchingConfig config_;
    Errors errors_;
    uint64_t observations_ = 0, covered_ = 0;
    std::map<core::PoseFault, uint64_t> faults_;
    Movement movement_;
    std::optional<mrpt::Clock::time_point> followed_;
};

}  // namespace offmap::rawlog
