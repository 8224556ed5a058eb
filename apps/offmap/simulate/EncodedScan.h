// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/Scanner.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// The scanner that a log is of, as its observations tell of it.
struct LogSensor {
    std::string label;
    mrpt::poses::CPose3D mounting;  ///< sensor in vehicle
    evaluation::Scanner scanner;
    bool compensated = true;  ///< clouds: the robot's movement during a turn is taken out
};

struct EncodedReturn {
    uint32_t slot;   ///< of the observation, as ScanClass counts them
    uint32_t point;  ///< of the simulated scan
};

struct EncodedObservation {
    mrpt::obs::CObservation::Ptr observation;
    std::vector<EncodedReturn> returns;  ///< by ascending slot
};

/// Writes a simulated turn in the encoding of one class of observations: all ranges are rounded as
/// that class does, what it cannot hold is no return.
using Encoder = std::vector<EncodedObservation> (*)(const evaluation::SimulatedScan& scan,
                                                    const LogSensor& sensor);

std::vector<EncodedObservation> encodeCloud(const evaluation::SimulatedScan& scan,
                                            const LogSensor& sensor);
/// \pre the scanner is evaluation::vlp16Firings()
std::vector<EncodedObservation> encodeVelodyne(const evaluation::SimulatedScan& scan,
                                               const LogSensor& sensor);
std::vector<EncodedObservation> encodeRotating(const evaluation::SimulatedScan& scan,
                                               const LogSensor& sensor);
/// One observation a column. \pre elevations evenly spaced, as far up as down
std::vector<EncodedObservation> encodeSweep(const evaluation::SimulatedScan& scan,
                                            const LogSensor& sensor);
/// \pre the scanner is evaluation::depthCamera()
std::vector<EncodedObservation> encodeRangeImage(const evaluation::SimulatedScan& scan,
                                                 const LogSensor& sensor);

/// The points of a scan by their beams.
class PointsByBeam {
 public:
    PointsByBeam(const evaluation::SimulatedScan& scan, const evaluation::Scanner& scanner);

    /// None if the beam did not return.
    std::optional<uint32_t> at(size_t column, size_t ring) const;

 private:
    size_t rings_;
    std::vector<std::optional<uint32_t>> points_;
};

/// [m] from the sensor
double rangeOf(const evaluation::SimulatedScan& scan, uint32_t point);
/// [0, 1]
float intensityOf(const evaluation::SimulatedScan& scan, uint32_t point);
/// 0 to 255 of [0, 1]
uint8_t eightBits(float share);

}  // namespace offmap::app
