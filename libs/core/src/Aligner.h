// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Alignment.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/WallInformation.h>
#include <offmap/core/WallSight.h>

#include <optional>
#include <span>
#include <vector>

namespace offmap::core {

/// What wall a sight may be of.
struct SightOnWall {
    uint32_t wall;  ///< index into LineMap::walls()
    bool fits;      ///< it lies on it by itself, wherever the prior lets it be
    double weight;  ///< [1/m^2]
    mrpt::math::TPoint2D normal;
};

/// The normal equations of one Gauss-Newton step.
struct NormalEquations {
    Matrix5 information;
    Vector5 slope;
    double fittedShare = 0;
};

/// The search for a scan's most probable poses, from one beginning.
class Aligner {
 public:
    Aligner(std::span<const WallSight> sights, const LineMap& map, const PoseCorrection& prior,
            const AlignmentConfig& config, AlignmentScratch& scratch);

    /// \param turn [rad] of the heading to begin with \return none: it leads to where `known` is
    std::optional<Alignment> run(double turn, const Alignment& known);

    /// See Alignment.
    double throughShare(const PoseCorrection& at) const;

 private:
    double openVariance(const WallSight& sight) const;
    double widestOpen() const;
    std::optional<SightOnWall> candidate(const WallSight& sight, const CorrectedColumn& column,
                                         double priorShare) const;
    WallInformation& informationOf(uint32_t wall);
    void add(const WallSight& sight, const CorrectedColumn& column, const SightOnWall& candidate);
    NormalEquations look(const PoseCorrection& at, double priorShare, size_t mostSights);
    Vector5 step(Alignment& out, double priorShare, size_t mostSights);

    std::span<const WallSight> sights_;
    const LineMap& map_;
    const PoseCorrection& prior_;
    Matrix5 priorInformation_;
    const AlignmentConfig& config_;
    AlignmentScratch& scratch_;
};

}  // namespace offmap::core
