// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnLines.h"

#include <map>
#include <memory>
#include <ogrsf_frmts.h>

namespace offmap::maps {

/// Brings the layers of a file into one coordinate reference system: that of its first lines.
class CommonSystem {
 public:
    explicit CommonSystem(DrawnLines& drawn) : drawn_(drawn) {}

    /// The points from this index on are of that layer.
    void take(OGRLayer& layer, size_t from);

 private:
    using Conversion = std::unique_ptr<OGRCoordinateTransformation>;
    Conversion conversionOf(OGRLayer& layer);

    DrawnLines& drawn_;
    bool isKnown_ = false;
    std::map<const OGRLayer*, Conversion> conversions_;  ///< null: none needed
};

}  // namespace offmap::maps
