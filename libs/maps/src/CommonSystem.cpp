// SPDX-License-Identifier: BSD-3-Clause
#include "CommonSystem.h"

#include "Coordinates.h"
#include "PrintableName.h"

#include <fmt/format.h>

#include <span>
#include <utility>

namespace offmap::maps {

void CommonSystem::take(OGRLayer& layer, size_t from) {
    if (from == drawn_.points.size()) return;
    auto found = conversions_.find(&layer);
    if (found == conversions_.end()) {
        found = conversions_.emplace(&layer, conversionOf(layer)).first;
    }
    if (found->second) convert(*found->second, std::span(drawn_.points).subspan(from));
}

CommonSystem::Conversion CommonSystem::conversionOf(OGRLayer& layer) {
    const OGRSpatialReference* system = layer.GetSpatialRef();
    if (!std::exchange(isKnown_, true)) {
        if (system != nullptr) drawn_.system = *system;
        return nullptr;
    }
    if (system != nullptr && drawn_.system && !drawn_.system->IsSame(system)) {
        Conversion made(OGRCreateCoordinateTransformation(system, &*drawn_.system));
        if (made) return made;
    }
    const bool isSame = (system == nullptr) == !drawn_.system &&
                        (system == nullptr || drawn_.system->IsSame(system) != 0);
    if (!isSame) {
        drawn_.warnings.push_back(fmt::format(
            "layer {} has another coordinate reference system than the layers before it, which "
            "cannot be converted: its coordinates are taken for theirs; --map-exclude-layer leaves "
            "it out",
            printableName(layer.GetName())));
    }
    return nullptr;
}

}  // namespace offmap::maps
