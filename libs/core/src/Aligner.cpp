// SPDX-License-Identifier: BSD-3-Clause
#include "Aligner.h"

#include "RootOfSquares.h"

#include <offmap/core/WallGate.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/core/WallInformation.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double widestLook = 1.5;  // [m] for a wall, however uncertain the pose

/// [m] What straight lines leave open of real walls, and neighbouring returns have in common.
constexpr double modelError = 0.01;

/// Geman and McClure's: a sight far off hardly pulls at all, however far.
double robustWeight(double squaredDistance, double variance) {
    const double root = 2 * variance / (2 * variance + squaredDistance);
    return root * root;
}

double shareOf(size_t some, size_t all) {
    return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0;
}

/// Whether shift and turn are too small to be worth another step.
bool isSmall(const Vector5& change) {
    constexpr double shift = 0.003, turn = 0.001;  // [m], [rad]
    return change.head<2>().norm() < shift && std::abs(change[2]) < turn;
}

}  // namespace

Aligner::Aligner(std::span<const WallSight> sights, const LineMap& map, const PoseCorrection& prior,
                 const AlignmentConfig& config, AlignmentScratch& scratch)
    : sights_(sights),
      map_(map),
      prior_(prior),
      priorInformation_(prior.covariance.inverse()),
      config_(config),
      scratch_(scratch) {}

/// [m^2] Bound of what the prior leaves open of a sight's place.
double Aligner::openVariance(const WallSight& sight) const {
    const TPoint2D reach = sight.place.position + sight.middle().ground - prior_.pivot;
    const Matrix5& c = prior_.covariance;
    const double z = sight.middle().z;
    return c(0, 0) + c(1, 1) + reach.sqrNorm() * c(2, 2) + z * z * (c(3, 3) + c(4, 4));
}

double Aligner::widestOpen() const {
    constexpr size_t enough = 20;  // of the sights, to know the largest roughly
    const size_t stride = std::max<size_t>(1, sights_.size() / enough);
    double widest = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        widest = std::max(widest, openVariance(sights_[i]));
    }
    return std::sqrt(widest);
}

std::optional<SightOnWall> Aligner::candidate(const WallSight& sight, const CorrectedColumn& column,
                                              double priorShare) const {
    const SeenPoint middle = sight.middle();
    const double gate = config_.gate;
    const double byPrior = priorShare > 0 ? priorShare * priorShare * openVariance(sight) : 0;
    const double byMap = map_.largestSigma();
    const double byRange = sight.rangeSigma.value_or(config_.sigmaRange) + modelError;
    const double look = gate * std::sqrt(byPrior + byMap * byMap + byRange * byRange);
    const TPoint2D place = column.place(middle);
    const auto near = map_.nearestWall(place, std::min(look, widestLook), sight.heightInMap);
    if (!near) return std::nullopt;
    const Wall& wall = map_.walls()[near->wall];
    const TPoint2D normal = map_.normalAwayFrom(sight.beam, near->wall, place);
    const double noise = varianceOfSight(sight, normal, config_) + modelError * modelError;
    const double own = noise + wall.sigma * wall.sigma;
    double open = 0;
    if (priorShare > 0) {
        const Vector5 gradient = column.gradient(middle, normal);
        open = priorShare * priorShare * gradient.dot(prior_.covariance * gradient);
    }
    const double squared = near->distance * near->distance;
    if (squared > gate * gate * (own + open)) return std::nullopt;
    return SightOnWall{near->wall, squared <= gate * gate * own,
                       0.5 * robustWeight(squared, own + open) / noise, normal};
}

/// Mostly, that of the sight before.
WallInformation& Aligner::informationOf(uint32_t wall) {
    auto& [walls, informations] = scratch_;
    const auto known = std::find(walls.rbegin(), walls.rend(), wall);
    if (known != walls.rend()) return informations[static_cast<size_t>(walls.rend() - known) - 1];
    walls.push_back(wall);
    return informations.emplace_back();
}

/// What a sight tells of the wall that it may be of.
void Aligner::add(const WallSight& sight, const CorrectedColumn& column,
                  const SightOnWall& candidate) {
    const Wall& wall = map_.walls()[candidate.wall];
    WallInformation& information = informationOf(candidate.wall);
    for (const SeenPoint& point : {sight.lower, sight.upper}) {
        const TPoint2D seen = column.place(point);
        information.add(column.gradient(point, candidate.normal), shareAlong(wall, seen),
                        distanceBehind(seen, wall, candidate.normal), candidate.weight);
    }
}

/// At every so many sights.
NormalEquations Aligner::look(const PoseCorrection& at, double priorShare, size_t mostSights) {
    auto& [walls, informations] = scratch_;
    walls.clear();
    informations.clear();
    const Turn turn(at);
    const size_t stride = std::max<size_t>(1, sights_.size() / mostSights);
    size_t looked = 0, fitted = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        const CorrectedColumn column(at, turn, sights_[i].place);
        const auto found = candidate(sights_[i], column, priorShare);
        if (found) add(sights_[i], column, *found);
        ++looked;
        if (found && found->fits) ++fitted;
    }
    NormalEquations out{priorInformation_, priorInformation_ * at.mean, shareOf(fitted, looked)};
    constexpr double leastSigma = 1e-3;  // [m] a map is not exact, whatever it says
    for (size_t w = 0; w < walls.size(); ++w) {
        const double sigma = std::max(map_.walls()[walls[w]].sigma, leastSigma);
        informations[w].marginalise(sigma, out.information, out.slope);
    }
    return out;
}

/// One Gauss-Newton step. \return what it changed
Vector5 Aligner::step(Alignment& out, double priorShare, size_t mostSights) {
    const NormalEquations equations = look(out.correction, priorShare, mostSights);
    const Eigen::LDLT<Matrix5> solver(equations.information);
    Vector5 change = -solver.solve(equations.slope);
    out.correction.mean += change;
    out.correction.covariance = solver.solve(Matrix5::Identity());
    out.fittedShare = equations.fittedShare;
    return change;
}

/// Walls are looked for within what the prior leaves open first, and ever closer by, until that is
/// no more than what a sight may be off by itself.
std::optional<Alignment> Aligner::run(double turn, const Alignment& known) {
    constexpr size_t fewSights = 150, manySights = 400;  // more cost time and add little
    constexpr int mostSteps = 40;
    constexpr double shrinking = 0.6;  // any faster, and walls get out of sight
    Alignment out;
    out.correction = prior_;
    out.correction.mean[2] = turn;
    const double closest = 0.5 * rootOfSquares(map_.largestSigma(), modelError);
    const double open = widestOpen();
    for (double share = 1; share * open > closest; share *= shrinking) {
        step(out, share, fewSights);
        if (known.converged && isSmall(out.correction.mean - known.correction.mean)) {
            return std::nullopt;
        }
    }
    for (int i = 0; i < mostSteps && !out.converged; ++i) {
        out.converged = isSmall(step(out, 0, manySights));
    }
    out.converged =
        out.converged && out.correction.mean.allFinite() && out.correction.covariance.allFinite();
    return out;
}

double Aligner::throughShare(const PoseCorrection& at) const {
    constexpr size_t enough = 200;   // of the sights
    constexpr double clearly = 0.3;  // [m]
    const size_t stride = std::max<size_t>(1, sights_.size() / enough);
    const Turn turn(at);
    size_t looked = 0, through = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        const WallSight& sight = sights_[i];
        const CorrectedColumn column(at, turn, sight.place);
        const TPoint2D from = column.place({{0, 0}, 0});
        const TPoint2D ray = column.place(sight.middle()) - from;
        const double range = ray.norm();
        ++looked;
        if (range > clearly &&
            map_.castRay(from, ray * (1 / range), range - clearly, sight.heightInMap)) {
            ++through;
        }
    }
    return shareOf(through, looked);
}

}  // namespace offmap::core
