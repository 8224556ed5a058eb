// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Alignment.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ScanAlignment.h>
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
    std::optional<SightOnWall> candidate(uint32_t index, const CorrectedColumn& column,
                                         double priorShare, bool& fits) const;
    double findCandidates(const PoseCorrection& at, const Turn& turn, double priorShare,
                          size_t stride);
    void addWall(std::span<const SightOnWall> candidates, const PoseCorrection& at,
                 const Turn& turn, NormalEquations& equations) const;
    NormalEquations look(const PoseCorrection& at, double priorShare, size_t mostSights);
    Vector5 step(Alignment& out, double priorShare, size_t mostSights);

    std::span<const WallSight> sights_;
    const LineMap& map_;
    const PoseCorrection& prior_;
    Matrix5 priorInformation_;
    const AlignmentConfig& config_;
    std::vector<SightOnWall>& candidates_;
};

}  // namespace offmap::core
