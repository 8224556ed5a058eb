// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/Score.h>
#include <offmap/evaluation/TruthFile.h>

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::evaluation {

struct TruthMatch {
    std::vector<ScoredPoint> points;  ///< one per point of the truth
    uint64_t unknown = 0;             ///< points that are left, but not in the truth
};

/// Finds out which returns of an observation were removed. \param left what is left of it [m]; a
/// point stands for one of the truth with the same bits, each for one only, in their order
TruthMatch matchTruth(std::span<const TruePoint> truth,
                      std::span<const mrpt::math::TPoint3Df> left);

}  // namespace offmap::evaluation
