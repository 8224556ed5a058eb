// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapFile.h>
#include <offmap/view/PlanFigure.h>

#include <string>

namespace offmap::app {

/// The walls in the colours of their layers. \param name of the map, to stand above
view::PlanFigure figureOf(const maps::MapOfFile& map, const std::string& name);

}  // namespace offmap::app
