// SPDX-License-Identifier: BSD-3-Clause
#include "Aligner.h"

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
double robustWeight(double distance, double variance) {
    const double x = 1 + distance * distance / (2 * variance);
    return 1 / (x * x);
}

}  // namespace

Aligner::Aligner(std::span<const WallSight> sights, const LineMap& map, const PoseCorrection& prior,
                 const AlignmentConfig& config)
    : sights_(sights),
      map_(map),
      prior_(prior),
      priorInformation_(prior.covariance.inverse()),
      config_(config) {}

/// [m] Bound of what the prior leaves open of a sight's place.
double Aligner::openAt(const WallSight& sight) const {
    const TPoint2D reach = sight.place.position + sight.middle().ground - prior_.pivot;
    const Matrix5& c = prior_.covariance;
    const double z = sight.middle().z;
    return std::sqrt(c(0, 0) + c(1, 1) + reach.sqrNorm() * c(2, 2) + z * z * (c(3, 3) + c(4, 4)));
}

double Aligner::widestOpen() const {
    constexpr size_t enough = 20;  // of the sights, to know the largest roughly
    const size_t stride = std::max<size_t>(1, sights_.size() / enough);
    double widest = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        widest = std::max(widest, openAt(sights_[i]));
    }
    return widest;
}

std::optional<Candidate> Aligner::candidate(uint32_t index, const PoseCorrection& at,
                                            double priorShare, bool& fits) const {
    const WallSight& sight = sights_[index];
    const CorrectedColumn column(at, sight.place);
    const SeenPoint middle = sight.middle();
    const double gate = config_.gate;
    const double look =
        gate * std::hypot(priorShare * openAt(sight), map_.largestSigma(),
                          sight.rangeSigma.value_or(config_.sigmaRange) + modelError);
    const TPoint2D place = column.place(middle);
    const auto near = map_.nearestWall(place, std::min(look, widestLook), sight.heightInMap);
    if (!near) return std::nullopt;
    const Wall& wall = map_.walls()[near->wall];
    const TPoint2D normal = normalAwayFrom(sight.beam, wall, place);
    const Vector5 gradient = column.gradient(middle, normal);
    const double noise = varianceOfSight(sight, normal, config_) + modelError * modelError;
    const double own = noise + wall.sigma * wall.sigma;
    const double open = priorShare * priorShare * gradient.dot(prior_.covariance * gradient);
    const double squared = near->distance * near->distance;
    if (squared > gate * gate * (own + open)) return std::nullopt;
    fits = squared <= gate * gate * own;
    return Candidate{near->wall, index, 0.5 * robustWeight(near->distance, own + open) / noise,
                     normal};
}

NormalEquations Aligner::look(const PoseCorrection& at, double priorShare, size_t mostSights) {
    candidates_.clear();
    const size_t stride = std::max<size_t>(1, sights_.size() / mostSights);
    size_t looked = 0, fitted = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        bool fits = false;
        const auto found = candidate(static_cast<uint32_t>(i), at, priorShare, fits);
        if (found) candidates_.push_back(*found);
        ++looked;
        if (fits) ++fitted;
    }
    NormalEquations out{priorInformation_, priorInformation_ * at.mean,
                        looked > 0 ? static_cast<double>(fitted) / static_cast<double>(looked) : 0};
    std::ranges::stable_sort(candidates_, {}, &Candidate::wall);
    for (auto first = candidates_.begin(); first != candidates_.end();) {
        const Wall& wall = map_.walls()[first->wall];
        const auto last = std::find_if(first, candidates_.end(),
                                       [&](const Candidate& c) { return c.wall != first->wall; });
        WallInformation information;
        for (; first != last; ++first) {
            const WallSight& sight = sights_[first->sight];
            const CorrectedColumn column(at, sight.place);
            for (const SeenPoint& point : {sight.lower, sight.upper}) {
                const TPoint2D seen = column.place(point);
                information.add(column.gradient(point, first->normal), shareAlong(wall, seen),
                                distanceBehind(seen, wall, first->normal), first->weight);
            }
        }
        constexpr double leastSigma = 1e-3;  // [m] a map is not exact, whatever it says
        information.marginalise(std::max(wall.sigma, leastSigma), out.information, out.slope);
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
Alignment Aligner::run(double turn) {
    constexpr double settledShift = 0.003, settledTurn = 0.001;  // [m], [rad]
    constexpr size_t fewSights = 150, manySights = 400;          // more cost time and add little
    constexpr int mostSteps = 40;
    constexpr double shrinking = 0.6;  // any faster, and walls get out of sight
    Alignment out;
    out.correction = prior_;
    out.correction.mean[2] = turn;
    const double closest = 0.5 * std::hypot(map_.largestSigma(), modelError);
    const double open = widestOpen();
    for (double share = 1; share * open > closest; share *= shrinking) step(out, share, fewSights);
    for (int i = 0; i < mostSteps && !out.converged; ++i) {
        const Vector5 change = step(out, 0, manySights);
        out.converged = change.head<2>().norm() < settledShift && std::abs(change[2]) < settledTurn;
    }
    out.converged =
        out.converged && out.correction.mean.allFinite() && out.correction.covariance.allFinite();
    return out;
}

double Aligner::throughShare(const PoseCorrection& at) const {
    constexpr size_t enough = 200;   // of the sights
    constexpr double clearly = 0.3;  // [m]
    const size_t stride = std::max<size_t>(1, sights_.size() / enough);
    size_t looked = 0, through = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        const WallSight& sight = sights_[i];
        const CorrectedColumn column(at, sight.place);
        const TPoint2D from = column.place({{0, 0}, 0});
        const TPoint2D ray = column.place(sight.middle()) - from;
        const double range = ray.norm();
        ++looked;
        if (range > clearly &&
            map_.castRay(from, ray * (1 / range), range - clearly, sight.heightInMap)) {
            ++through;
        }
    }
    return looked > 0 ? static_cast<double>(through) / static_cast<double>(looked) : 0;
}

}  // namespace offmap::core
