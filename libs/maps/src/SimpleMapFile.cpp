// SPDX-License-Identifier: BSD-3-Clause
#include "CellOfChance.h"

#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/SimpleMapFile.h>

#include <fmt/format.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace offmap::maps {

namespace {

using mrpt::obs::CObservation2DRangeScan;

constexpr double defaultResolution = 0.05;  // [m]

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw std::runtime_error(fmt::format("{}: {}", name, what));
}

mrpt::maps::CSimpleMap load(const std::string& name) {
    mrpt::maps::registerAllClasses_mrpt_maps();
    mrpt::io::CFileGZInputStream in;
    if (!in.open(name)) refuse(name, "cannot be read; is there such a file?");
    mrpt::maps::CSimpleMap map;
    try {
        mrpt::serialization::archiveFrom(in) >> map;
    } catch (const std::exception&) {  // MRPT tells its own code's places, not the file's
        refuse(name, "is no MRPT simple map, or it is damaged; save the map again");
    }
    return map;
}

/// The places of the scans.
struct Extent {
    double xMin = 0, xMax = 0, yMin = 0, yMax = 0;  ///< [m]
    size_t scans = 0;
};

Extent extentOf(const mrpt::maps::CSimpleMap& map, const std::string& name) {
    Extent extent;
    for (const auto& [pose, frame] : map) {
        if (!pose || !frame) refuse(name, "is damaged: a frame without pose or observations");
        const auto count = static_cast<size_t>(std::ranges::count_if(*frame, [](const auto& obs) {
            return obs && IS_CLASS(*obs, CObservation2DRangeScan);
        }));
        if (count == 0) continue;
        const auto place = pose->getMeanVal();
        if (!std::isfinite(place.x()) || !std::isfinite(place.y()) || !std::isfinite(place.yaw())) {
            refuse(name, "is damaged: a pose that is not finite");
        }
        const bool first = extent.scans == 0;
        extent.xMin = first ? place.x() : std::min(extent.xMin, place.x());
        extent.xMax = first ? place.x() : std::max(extent.xMax, place.x());
        extent.yMin = first ? place.y() : std::min(extent.yMin, place.y());
        extent.yMax = first ? place.y() : std::max(extent.yMax, place.y());
        extent.scans += count;
    }
    if (extent.scans == 0) {
        refuse(name, "holds no 2D laser scan, so there is nothing to draw a grid from");
    }
    return extent;
}

OccupancyGrid gridOfMap(const mrpt::maps::COccupancyGridMap2D& map, double resolution,
                        const std::string& name) {
    OccupancyGrid grid = makeGrid(map.getSizeX(), map.getSizeY(), resolution, Cell::Unknown, name);
    grid.origin = {static_cast<double>(map.getXMin()), static_cast<double>(map.getYMin()), 0};
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            grid.cells[grid.index(x, y)] = cellOfChance(map.getCell(x, y));
        }
    }
    return grid;
}

}  // namespace

Drawing readSimpleMap(const std::filesystem::path& file, const MapOptions& options) {
    const std::string name = file.string();
    const mrpt::maps::CSimpleMap map = load(name);
    const Extent extent = extentOf(map, name);
    const double resolution = options.resolution.value_or(defaultResolution);
    mrpt::maps::COccupancyGridMap2D drawn;
    // Refuses what would be too large, before it is drawn.
    const double reach = 2 * static_cast<double>(drawn.insertionOptions.maxDistanceInsertion);
    const auto cells = [&](double low, double high) {
        return static_cast<uint64_t>(std::clamp((high - low + reach) / resolution, 1.0, 1e15));
    };
    makeGrid(cells(extent.xMin, extent.xMax), cells(extent.yMin, extent.yMax), resolution,
             Cell::Unknown, name);
    const auto f = [](double value) { return static_cast<float>(value); };
    drawn.setSize(f(extent.xMin), f(extent.xMax) + 1, f(extent.yMin), f(extent.yMax) + 1,
                  f(resolution));
    drawn.loadFromSimpleMap(map);
    Drawing drawing = drawingOf(gridOfMap(drawn, resolution, name), options, "simple map", name);
    drawing.notes.push_back(fmt::format("grid: drawn from {} laser scans", extent.scans));
    return drawing;
}

}  // namespace offmap::maps
