// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/core/bits_math.h>

#include <vector>

namespace offmap::view {

/// A scanner at (10, 20, 1) in the map that looks along the map's y axis, and three poles of eleven
/// returns each, 4 m away from it: a mapped one to the left (map x = 6, y = 20), a kept one to the
/// right (x = 14) and one on no segment ahead (y = 24). The map has one wall, behind (y = 16).
struct SmallScan {
    core::OrganizedScan scan;
    core::ReductionResult result;
    core::LineMap map{{core::Wall{{{6, 16}, {14, 16}}, 0.03, {0, 2}}}};

    SmallScan() {
        addPole({0, 4}, core::PointLabel::Mapped);
        addPole({0, -4}, core::PointLabel::Kept);
        addPole({4, 0}, core::PointLabel::NotOnVerticalSegment);
    }

 private:
    void addPole(const mrpt::math::TPoint2Df& inSensor, core::PointLabel label) {
        core::ScanColumn column;
        column.begin = static_cast<uint32_t>(scan.points.size());
        for (int i = 0; i <= 10; ++i) {
            scan.points.emplace_back(inSensor.x, inSensor.y, -1.0F + 0.2F * static_cast<float>(i));
            result.labels.push_back(label);
        }
        column.end = static_cast<uint32_t>(scan.points.size());
        column.sensor.emplace().sensorInMap = {10, 20, 1, mrpt::DEG2RAD(90.0), 0, 0};
        scan.columns.push_back(column);
    }
};

}  // namespace offmap::view
