// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnLines.h"
#include "GdalSession.h"
#include "VectorFormat.h"

#include <offmap/maps/MapOptions.h>

#include <filesystem>

namespace offmap::maps {

/// Every line of a file that may be a wall. What the drawing hides is one if
/// MapOptions::layers names its layer.
/// \throw std::runtime_error with what is wrong and the fix, which does not name the file
DrawnLines readLines(const std::filesystem::path& file, const VectorFormat& format,
                     const MapOptions& options, const GdalSession& session);

}  // namespace offmap::maps
