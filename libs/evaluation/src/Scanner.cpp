// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Scanner.h>

#include <mrpt/core/bits_math.h>

#include <cmath>
#include <numbers>

namespace offmap::evaluation {

namespace {

/// The azimuths of a clockwise turn, which starts and ends behind the sensor.
std::vector<double> fullTurn(size_t columns) {
    std::vector<double> azimuths(columns);
    for (size_t i = 0; i < columns; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(columns);
        azimuths[i] = std::numbers::pi * (1 - 2 * share);
    }
    return azimuths;
}

/// \param first, last [deg]
std::vector<double> evenlySpaced(double first, double last, size_t count) {
    std::vector<double> elevations(count);
    for (size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        elevations[i] = mrpt::DEG2RAD(first + share * (last - first));
    }
    return elevations;
}

/// Angles under which the pixels of a line see, [rad] ascending.
std::vector<double> pixelAngles(size_t pixels, double focalLength) {
    std::vector<double> angles(pixels);
    for (size_t i = 0; i < pixels; ++i) {
        const double fromMiddle = static_cast<double>(i) - 0.5 * static_cast<double>(pixels - 1);
        angles[i] = std::atan(fromMiddle / focalLength);
    }
    return angles;
}

}  // namespace

BeamAngles beamAngles(const Scanner& scanner, size_t column, size_t ring) {
    BeamAngles beam{scanner.azimuths[column], scanner.elevations[ring]};
    if (!scanner.ringAzimuths.empty()) beam.azimuth += scanner.ringAzimuths[ring];
    if (scanner.isFlatImage) {
        beam.elevation = std::atan(std::tan(beam.elevation) * std::cos(beam.azimuth));
    }
    return beam;
}

Scanner paperScanner() { return {fullTurn(181), evenlySpaced(-90, 90, 181), 80, 2.4}; }

Scanner vlp16() { return {fullTurn(1800), evenlySpaced(-15, 15, 16), 100, 0.1}; }

Scanner dense() { return {fullTurn(2048), evenlySpaced(-22.5, 22.5, 128), 120, 0.1}; }

Scanner vlp16Firings() {
    constexpr double firingPeriod = 55.296e-6, laserPeriod = 2.304e-6;  // [s]
    Scanner scanner = vlp16();
    const auto firings = static_cast<double>(scanner.azimuths.size());
    scanner.turnDuration = firings * firingPeriod;
    const double perLaser = 2 * std::numbers::pi / firings * laserPeriod / firingPeriod;  // [rad]
    // The lasers fire in the order -15, 1, -13, 3, ... degrees.
    for (size_t ring = 0; ring < scanner.elevations.size(); ++ring) {
        const size_t laser = ring < 8 ? 2 * ring : 2 * ring - 15;
        scanner.ringAzimuths.push_back(-perLaser * static_cast<double>(laser));
    }
    return scanner;
}

Scanner depthCamera() {
    constexpr size_t columns = 320, rows = 240;
    const double focalLength = 0.5 * columns / std::tan(mrpt::DEG2RAD(30.0));  // [pixel]
    Scanner scanner{pixelAngles(columns, focalLength), pixelAngles(rows, focalLength), 10, 0};
    for (double& azimuth : scanner.azimuths) azimuth = -azimuth;
    scanner.isFlatImage = true;
    return scanner;
}

}  // namespace offmap::evaluation
