// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PlanePoints.h>

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace offmap::core {

/// A scan's points turned upright: from the sensor, along the axes of the map. Roll and pitch of
/// the vehicle and of the mounting are so undone before anything is called vertical. In a column
/// without a pose, the axes are those of the vehicle.
struct LevelledScan {
    uint32_t first = 0;        ///< of the scan's points that are held; 0, if all are
    std::vector<float> x, y;   ///< [m] per point, on the ground
    std::vector<float> range;  ///< [m] per point: ground range
    std::vector<float> z;      ///< [m] per point, above the sensor

    void resize(size_t points) {
        for (auto* values : {&x, &y, &range, &z}) values->resize(points);
    }
    /// In place of what is held: a column's room stays near the processor, a scan's does not.
    void holdOnly(uint32_t begin, uint32_t end) {
        first = begin;
        if (end - begin > x.size()) resize(end - begin);
    }

    /// \pre all points are held
    mrpt::math::TPoint2D ground(uint32_t point) const { return {x[point], y[point]}; }

    /// Points as (ground range, z).
    PlanePoints profile(uint32_t begin, uint32_t end) const {
        return PlanePoints{range, z}.range(begin - first, end - first);
    }
};

void level(const OrganizedScan& scan, LevelledScan& levelled);

/// The points of one column. \pre there is room for them
void levelColumn(const OrganizedScan& scan, uint32_t column, LevelledScan& levelled);

}  // namespace offmap::core
