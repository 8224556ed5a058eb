// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VectorFormat.h"

#include <ogrsf_frmts.h>
#include <optional>
#include <string>

namespace offmap::maps {

/// What a feature of a file is to a map.
struct FeatureClass {
    std::string layer;              ///< as the user is told of it
    const char* leftOut = nullptr;  ///< "hatches", if such are no walls; null: its lines are
    bool isHidden = false;          ///< the drawing does not show it
};

/// \param layer the feature's in GDAL
FeatureClass classify(OGRFeature& feature, OGRLayer& layer, VectorKind kind);

}  // namespace offmap::maps
