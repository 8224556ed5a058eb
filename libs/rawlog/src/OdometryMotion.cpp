// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/OdometryMotion.h>

#include <Eigen/Core>
#include <mrpt/poses/CPose2D.h>

#include <array>
#include <cmath>

namespace offmap::rawlog {
namespace {

/// A movement at constant speed and turn rate, in the frame of its beginning.
struct Arc {
    explicit Arc(const mrpt::math::TPose2D& increment)
        : turn(increment.phi),
          chordBearing(std::atan2(increment.y, increment.x)),
          length(std::hypot(increment.x, increment.y) / sinc(increment.phi / 2)) {}

    /// Where the vehicle is after a share of the movement [m].
    Eigen::Vector2d at(double share) const {
        const double half = turn / 2;
        const double chord = share * length * sinc(share * half);
        const double bearing = chordBearing - half + share * half;
        return {chord * std::cos(bearing), chord * std::sin(bearing)};
    }

    static double sinc(double angle) {
        return std::abs(angle) < 1e-8 ? 1 : std::sin(angle) / angle;  // 1 - angle^2 / 6
    }

    double turn;          ///< [rad] in [-pi, pi]
    double chordBearing;  ///< [rad]
    double length;        ///< [m] along the arc
};

double squared(double value) { return value * value; }

/// What an error of the heading somewhere on the way does to the end, summed up over the way:
/// the integral of [n; 1] [n; 1]^T, n being the rest of the way, turned by 90 degrees.
/// Gauss-Legendre of three points is exact on a straight line, where the integrand is quadratic.
Eigen::Matrix3d headingError(const Arc& arc) {
    const double offset = std::sqrt(0.15);
    const std::array<double, 3> shares{0.5 - offset, 0.5, 0.5 + offset};
    const std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    const Eigen::Vector2d end = arc.at(1);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (size_t i = 0; i < shares.size(); ++i) {
        const Eigen::Vector2d rest = end - arc.at(shares[i]);
        const Eigen::Vector3d effect(-rest.y(), rest.x(), 1);
        sum += weights[i] * effect * effect.transpose();
    }
    return sum;
}

}  // namespace

MotionStep motionBetween(const StampedOdometry& before, const StampedOdometry& after,
                         const OdometryConfig& noise) {
    const auto increment = (mrpt::poses::CPose2D(after.vehicleInOdometry) -
                            mrpt::poses::CPose2D(before.vehicleInOdometry))
                               .asTPose();
    if (!std::isfinite(increment.x) || !std::isfinite(increment.y) ||
        !std::isfinite(increment.phi)) {
        return {after.time, {}, {}, core::PoseFault::NotFinite};
    }
    const Arc arc(increment);
    Eigen::Matrix3d covariance = (squared(noise.headingPerMetre) * arc.length +
                                  squared(noise.headingPerRadian) * std::abs(arc.turn)) *
                                 headingError(arc);
    covariance.diagonal().head<2>().array() += squared(noise.positionPerMetre) * arc.length;
    return {after.time, mrpt::math::TPose3D(increment), triangleOf(covariance), {}};
}

}  // namespace offmap::rawlog
