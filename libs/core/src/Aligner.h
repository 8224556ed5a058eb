// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Alignment.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/WallSight.h>

#include <optional>
#include <span>
#include <vector>

namespace offmap::core {

/// The normal equations of one Gauss-Newton step.
struct NormalEquations {
    Matrix5 information;
    Vector5 slope;
    double fittedShare = 0;
};

/// A sight that may be of a wall.
struct Candidate {
    uint32_t wall;
    uint32_t sight;
    double weight;  // [1/m^2]
    mrpt::math::TPoint2D normal;
};

/// The search for a scan's most probable poses, from one beginning.
class Aligner {
 public:
    Aligner(std::span<const WallSight> sights, const LineMap& map, const PoseCorrection& prior,
            const AlignmentConfig& config);

    /// \param turn [rad] of the heading to begin with
    Alignment run(double turn);

    /// See Alignment.
    double throughShare(const PoseCorrection& at) const;

 private:
    double openAt(const WallSight& sight) const;
    double widestOpen() const;
    std::optional<Candidate> candidate(uint32_t index, const PoseCorrection& at, double priorShare,
                                       bool& fits) const;
    NormalEquations look(const PoseCorrection& at, double priorShare, size_t mostSights);
    Vector5 step(Alignment& out, double priorShare, size_t mostSights);

    std::span<const WallSight> sights_;
    const LineMap& map_;
    const PoseCorrection& prior_;
    Matrix5 priorInformation_;
    const AlignmentConfig& config_;
    std::vector<Candidate> candidates_;
};

}  // namespace offmap::core
