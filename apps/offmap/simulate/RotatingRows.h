// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/Scanner.h>

#include <string>
#include <vector>

namespace offmap::app {

/// CObservationRotatingScan::lidarModel of a scanner. That of a VLP-16 is known, and with it the
/// elevations of its rows; of another scanner, sensor.elevations_deg has to tell them.
std::string rotatingModel(const evaluation::Scanner& scanner);

/// Per row of the range image, from row 0: the ring, counted from the lowest. Those of a known
/// model stand in its order.
std::vector<size_t> ringsOfRows(const evaluation::Scanner& scanner);

}  // namespace offmap::app
