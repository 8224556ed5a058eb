// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ScanAlignment.h>
#include <offmap/core/WallGate.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/core/WallInformation.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr size_t mostSights = 500;  // more of them cost time and add nothing to a pose
constexpr double widestLook = 1.5;  // [m] for a wall, however uncertain the pose

/// [m] What straight lines leave open of real walls, and neighbouring returns have in common.
constexpr double modelError = 0.01;

/// How much of the prior's uncertainty is left in each iteration.
constexpr std::array<double, 10> shares = {1, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05, 0, 0, 0};

/// Geman and McClure's: a sight far off hardly pulls at all, however far.
double robustWeight(double distance, double variance) {
    const double x = 1 + distance * distance / (2 * variance);
    return 1 / (x * x);
}

/// The normal equations of one Gauss-Newton step.
struct NormalEquations {
    Matrix5 information;
    Vector5 slope;
    double fittedShare = 0;
};

class Aligner {
 public:
    Aligner(std::span<const WallSight> sights, const LineMap& map, const PoseCorrection& prior,
            const AlignmentConfig& config)
        : sights_(sights),
          map_(map),
          prior_(prior),
          priorInformation_(prior.covariance.inverse()),
          config_(config) {}

    Alignment run() const;

 private:
    NormalEquations look(const PoseCorrection& at, double priorShare) const;

    std::span<const WallSight> sights_;
    const LineMap& map_;
    const PoseCorrection& prior_;
    Matrix5 priorInformation_;
    const AlignmentConfig& config_;
};

NormalEquations Aligner::look(const PoseCorrection& at, double priorShare) const {
    std::map<uint32_t, WallInformation> walls;  // in order: sums do not depend on an address
    const size_t stride = std::max<size_t>(1, sights_.size() / mostSights);
    size_t looked = 0, fitted = 0;
    for (size_t i = 0; i < sights_.size(); i += stride) {
        const WallSight& sight = sights_[i];
        ++looked;
        const TPoint2D place = at.apply(sight.place, sight.middle());
        const auto near = map_.nearestWall(place, widestLook, sight.heightInMap);
        if (!near) continue;
        const Wall& wall = map_.walls()[near->wall];
        const TPoint2D normal = normalAwayFrom(sight.beam, wall, place);
        const Vector5 gradient = at.gradient(sight.place, sight.middle(), normal);
        const double noise = varianceOfSight(sight, normal, config_) + modelError * modelError;
        const double own = noise + wall.sigma * wall.sigma;
        const double open = priorShare * priorShare * gradient.dot(prior_.covariance * gradient);
        const double gate = config_.gate * config_.gate;
        if (near->distance * near->distance > gate * (own + open)) continue;
        if (near->distance * near->distance <= gate * own) ++fitted;

        const double weight = 0.5 * robustWeight(near->distance, own + open) / noise;
        for (const SeenPoint& point : {sight.lower, sight.upper}) {
            const TPoint2D seen = at.apply(sight.place, point);
            walls[near->wall].add(at.gradient(sight.place, point, normal), shareAlong(wall, seen),
                                  distanceBehind(seen, wall, normal), weight);
        }
    }
    NormalEquations out{priorInformation_, priorInformation_ * at.mean,
                        looked > 0 ? static_cast<double>(fitted) / static_cast<double>(looked) : 0};
    for (const auto& [index, information] : walls) {
        constexpr double leastSigma = 1e-3;  // [m] a map is not exact, whatever it says
        information.marginalise(std::max(map_.walls()[index].sigma, leastSigma), out.information,
                                out.slope);
    }
    return out;
}

Alignment Aligner::run() const {
    constexpr double settledShift = 0.005, settledTurn = 0.002;  // [m], [rad]
    Alignment out;
    out.correction = prior_;
    Vector5 change = Vector5::Zero();
    for (const double share : shares) {
        const NormalEquations equations = look(out.correction, share);
        const Eigen::LDLT<Matrix5> solver(equations.information);
        change = -solver.solve(equations.slope);
        out.correction.mean += change;
        out.correction.covariance = solver.solve(Matrix5::Identity());
    }
    out.fittedShare = look(out.correction, 0).fittedShare;
    out.converged = out.correction.mean.allFinite() && out.correction.covariance.allFinite() &&
                    change.head<2>().norm() < settledShift && std::abs(change[2]) < settledTurn;
    return out;
}

}  // namespace

bool Alignment::contradictsPrior() const {
    constexpr double rarely = 16.3;  // chi-square of 3 degrees exceeds it once in a thousand
    return priorInflation > 1 || priorChiSquare > rarely;
}

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
                const Eigen::Matrix3d& stated, const AlignmentConfig& config) {
    constexpr double clearlyMore = 0.1, nearlyAll = 0.8;  // of the sights
    const Eigen::Matrix3d prior =
        uncorrected(pivot, stated, config).covariance.topLeftCorner<3, 3>();
    Alignment best;
    for (const double inflation : {1.0, 3.0, 8.0}) {
        const PoseCorrection own = uncorrected(pivot, inflation * inflation * stated, config);
        Alignment tried = Aligner(sights, map, own, config).run();
        tried.priorInflation = inflation;
        const Eigen::Vector3d moved = tried.correction.mean.head<3>();
        tried.priorChiSquare = moved.dot(prior.ldlt().solve(moved));
        if (inflation == 1.0 || tried.fittedShare > best.fittedShare + clearlyMore) best = tried;
        if (best.fittedShare > nearlyAll) break;
    }
    return best;
}

}  // namespace offmap::core
