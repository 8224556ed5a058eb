// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnLines.h"

#include <ogrsf_frmts.h>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace offmap::maps {

/// Gathers the lines of geometries of every kind; curves become fine lines.
class LineGatherer {
 public:
    explicit LineGatherer(DrawnLines& drawn) : drawn_(drawn) {}

    uint32_t layerIndex(const std::string& name);

    /// \throw std::runtime_error if that is more than a map can hold
    void add(const OGRFeature& feature, uint32_t layer);

 private:
    void add(const OGRGeometry& geometry);
    void addPlaces(const OGRSimpleCurve& line);

    DrawnLines& drawn_;
    DrawnLines::Line line_{};  ///< what holds for the lines of this feature
    std::unordered_map<std::string, uint32_t> layerOf_;
};

}  // namespace offmap::maps
