// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/SimulatedScan.h>
#include <offmap/evaluation/UniformNumbers.h>

#include <vector>

namespace offmap::evaluation {

/// Fires single beams.
class Beams {
 public:
    /// \throw std::invalid_argument if a term of the noise is out of its range
    Beams(const World& world, const Scanner& scanner, const ScannerNoise& noise, uint64_t seed);

    void fireFrom(const mrpt::poses::CPose3D& sensorInMap) { sensorInMap_ = sensorInMap; }

    /// Adds the return, if there is one. The beam leaves off its direction by the noise of the
    /// angles; its point is put where the beam should have gone.
    void fire(const BeamAngles& angles, uint32_t sourceIndex, SimulatedScan& result);

 private:
    float intensityOf(const WorldHit& hit, const mrpt::math::TVector3D& direction) const;
    /// The range at which a beam returns whose axis meets a surface, if not from there: between it
    /// and another one that the beam's footprint meets as well.
    std::optional<double> mixedRange(const WorldHit& hit, const BeamAngles& angles);

    const World& world_;
    const Scanner& scanner_;
    const ScannerNoise& noise_;
    mrpt::poses::CPose3D sensorInMap_;
    GaussianNoise random_, darkness_;  ///< streams of their own, so that a term added to the noise
    UniformNumbers footprint_;         ///< changes none of the others
    std::vector<PointTruth> truths_;   ///< one per surface
};

}  // namespace offmap::evaluation
