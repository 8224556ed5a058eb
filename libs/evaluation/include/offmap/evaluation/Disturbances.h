// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/SensorPose.h>
#include <offmap/evaluation/GaussianNoise.h>

#include <vector>

namespace offmap::evaluation {

/// The map as a survey of this accuracy would draw it: the ends of the walls are off by errors of
/// this sigma in x and in y. Walls that share an end go on sharing it, as a corner is surveyed
/// once. Wall::sigma says the sigma. [m]
/// \throw std::invalid_argument if sigma is negative or not finite
std::vector<core::Wall> withMapError(std::vector<core::Wall> walls, double sigma,
                                     GaussianNoise& noise);

/// A sensor that was not mounted straight: its z axis leans over.
/// \param tilt [rad] by which it leans
/// \param direction [rad] towards which, CCW from the sensor's x axis
core::SensorPose tilted(core::SensorPose sensor, double tilt, double direction);

/// An estimate whose covariance is too large or too small: its standard deviations times a factor.
/// \throw std::invalid_argument if the factor is negative or not finite
core::SensorPose withStatedSigma(core::SensorPose estimate, double factor);

/// A pose that is wrong by a shift on the ground and a turn about the vertical at its own place.
/// \param shift [m] \param direction [rad] of the shift, in the map \param turn [rad] CCW
core::SensorPose misplaced(core::SensorPose sensor, double shift, double direction, double turn);

}  // namespace offmap::evaluation
