// SPDX-License-Identifier: BSD-3-Clause
#include "Aligner.h"

#include <offmap/core/ScanAlignment.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double rarely = 16.3;  // chi-square of 3 degrees exceeds it once in a thousand

/// Whether the scan itself tells x, y and heading. One wall, or two that are parallel, fit in many
/// places.
bool isDetermined(const PoseCorrection& correction) {
    constexpr double shift = 0.05, turn = 0.01;  // [m], [rad]
    const Eigen::Matrix3d left = correction.covariance.topLeftCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> position(left.topLeftCorner<2, 2>(),
                                                                  Eigen::EigenvaluesOnly);
    return position.info() == Eigen::Success && position.eigenvalues()(1) < shift * shift &&
           left(2, 2) < turn * turn;
}

}  // namespace

bool Alignment::fits(double minFittedShare) const {
    constexpr double leastShare = 0.1;  // of all: so many are on a wall by chance
    return converged && fittedShare >= leastShare &&
           fittedShare >= minFittedShare * (fittedShare + throughShare);
}

bool Alignment::contradictsPrior() const { return priorInflation > 1 || priorChiSquare > rarely; }

PoseCorrection uncorrected(const TPoint2D& pivot, const Eigen::Matrix3d& stated,
                           const AlignmentConfig& config) {
    // A stated covariance of 0 cannot be inverted, nor be meant.
    constexpr double leastPosition = 1e-3, leastHeading = 2e-4;  // [m], [rad]
    PoseCorrection out;
    out.pivot = pivot;
    out.covariance.topLeftCorner<3, 3>() = stated;
    out.covariance.diagonal().head<2>().array() += leastPosition * leastPosition;
    out.covariance(2, 2) += leastHeading * leastHeading;
    out.covariance.diagonal().tail<2>().setConstant(config.sigmaTilt * config.sigmaTilt);
    return out;
}

Alignment align(std::span<const WallSight> sights, const LineMap& map, const TPoint2D& pivot,
                const Eigen::Matrix3d& stated, const AlignmentConfig& config,
                AlignmentScratch& scratch) {
    constexpr double somewhatMore = 0.02, clearlyMore = 0.1, nearlyAll = 0.8;  // of the sights
    // [rad] A heading less certain is begun with from several sides: far walls are then out of
    // sight of where the prior puts them.
    constexpr double uncertainHeading = 0.02;
    const Eigen::LDLT<Eigen::Matrix3d> prior(
        uncorrected(pivot, stated, config).covariance.topLeftCorner<3, 3>());
    Alignment best;
    double widestBetter = 1;  // inflation with which more sights fit, if not clearly more
    for (const double inflation : {1.0, 3.0, 8.0}) {
        if (inflation == 3.0 && best.fittedShare > nearlyAll) continue;
        if (best.fittedShare >= 1 - somewhatMore) break;  // nothing could fit better
        const PoseCorrection own = uncorrected(pivot, inflation * inflation * stated, config);
        const double sigmaHeading = std::sqrt(own.covariance(2, 2));
        for (const double turn : {0.0, -1.0, 1.0, -2.0, 2.0}) {
            if (turn != 0 && (best.fittedShare > 0.5 || sigmaHeading < uncertainHeading)) break;
            auto tried = Aligner(sights, map, own, config, scratch).run(turn * sigmaHeading, best);
            if (!tried) continue;
            tried->priorInflation = inflation;
            const Eigen::Vector3d moved = tried->correction.mean.head<3>();
            tried->priorChiSquare = moved.dot(prior.solve(moved));
            const bool first = inflation == 1.0 && turn == 0;
            const bool allowed = inflation == 1.0 || isDetermined(tried->correction);
            if (first || (allowed && tried->fittedShare > best.fittedShare + clearlyMore)) {
                best = *tried;
            } else if (allowed && tried->priorChiSquare > rarely &&
                       tried->fittedShare > best.fittedShare + somewhatMore) {
                widestBetter = inflation;
            }
        }
    }
    // Not clearly enough to move there, but to doubt the pose: an end of a corridor tells little.
    best.priorInflation = std::max(best.priorInflation, widestBetter);
    best.throughShare =
        Aligner(sights, map, best.correction, config, scratch).throughShare(best.correction);
    return best;
}

}  // namespace offmap::core
