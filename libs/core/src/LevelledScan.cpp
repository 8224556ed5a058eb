// SPDX-License-Identifier: BSD-3-Clause
#include "Lanes.h"

#include <offmap/core/LevelledScan.h>

namespace offmap::core {

using mrpt::math::CMatrixDouble33;
using mrpt::math::TPoint3Df;

namespace {

/// Turns as many points as an array has numbers.
template <class Array>
void turn(const CMatrixDouble33& rotation, const Array& x, const Array& y, const Array& z,
          uint32_t to, LevelledScan& levelled) {
    using Out = Eigen::Map<Array>;
    const Array east = rotation(0, 0) * x + rotation(0, 1) * y + rotation(0, 2) * z;
    const Array north = rotation(1, 0) * x + rotation(1, 1) * y + rotation(1, 2) * z;
    Out(levelled.x.data() + to) = east;
    Out(levelled.y.data() + to) = north;
    Out(levelled.range.data() + to) = (east * east + north * north).sqrt();
    Out(levelled.z.data() + to) = rotation(2, 0) * x + rotation(2, 1) * y + rotation(2, 2) * z;
}

void levelColumn(const CMatrixDouble33& rotation, const OrganizedScan& scan,
                 const ScanColumn& column, LevelledScan& levelled) {
    using Single = Eigen::Array<double, 1, 1>;
    uint32_t i = column.begin;
    for (; i + laneCount <= column.end; i += laneCount) {
        const TPoint3Df* p = scan.points.data() + i;
        turn(rotation, Lanes(p[0].x, p[1].x, p[2].x, p[3].x), Lanes(p[0].y, p[1].y, p[2].y, p[3].y),
             Lanes(p[0].z, p[1].z, p[2].z, p[3].z), i, levelled);
    }
    for (; i < column.end; ++i) {
        const TPoint3Df& p = scan.points[i];
        turn(rotation, Single(p.x), Single(p.y), Single(p.z), i, levelled);
    }
}

}  // namespace

void level(const OrganizedScan& scan, LevelledScan& levelled) {
    for (auto* values : {&levelled.x, &levelled.y, &levelled.range, &levelled.z}) {
        values->resize(scan.points.size());
    }
    for (const ScanColumn& column : scan.columns) {
        levelColumn(column.sensor
                        ? column.sensor->sensorInMap.getRotationMatrix()
                        : mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix(),
                    scan, column, levelled);
    }
}

}  // namespace offmap::core
