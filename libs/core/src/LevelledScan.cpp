// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>
#include <offmap/core/LevelledScan.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::CMatrixDouble33;
using mrpt::math::TPoint3Df;

namespace {

struct Rotation {
    explicit Rotation(const CMatrixDouble33& matrix) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                r[row][column] = static_cast<float>(matrix(row, column));
            }
        }
    }
    float r[3][3];
};

/// As many points as there are lanes, coordinate by coordinate: half of them in the lower half of
/// each register, whose halves are shuffled alike.
[[gnu::always_inline]] inline void load(const TPoint3Df* points, Lanes& x, Lanes& y, Lanes& z) {
    const float* const p = &points->x;
    Lanes a, b, c;  // x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3; and the same of points 4 to 7
    loadHalves(p, p + 12, a);
    loadHalves(p + 4, p + 16, b);
    loadHalves(p + 8, p + 20, c);
    const Lanes xy = __builtin_shufflevector(b, c, 2, 3, 9, 10, 6, 7, 13, 14);  // x2 y2 x3 y3
    const Lanes yz = __builtin_shufflevector(a, b, 1, 2, 8, 9, 5, 6, 12, 13);   // y0 z0 y1 z1
    x = __builtin_shufflevector(a, xy, 0, 3, 8, 10, 4, 7, 12, 14);
    y = __builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15);
    z = __builtin_shufflevector(yz, c, 1, 3, 8, 11, 5, 7, 12, 15);
}
[[gnu::always_inline]] inline void load(const TPoint3Df* point, float& x, float& y, float& z) {
    x = point->x, y = point->y, z = point->z;
}

/// Turns points of the sensor upright: one, or as many as there are lanes.
template <class Numbers>
[[gnu::always_inline]] inline void turn(const Rotation& rotation, const TPoint3Df* points, float* x,
                                        float* y, float* range, float* z) {
    const auto& r = rotation.r;
    Numbers px, py, pz, ranges;
    load(points, px, py, pz);
    const Numbers east = r[0][0] * px + r[0][1] * py + r[0][2] * pz;
    const Numbers north = r[1][0] * px + r[1][1] * py + r[1][2] * pz;
    store(east, x);
    store(north, y);
    squareRoots(east * east + north * north, ranges);
    store(ranges, range);
    store(r[2][0] * px + r[2][1] * py + r[2][2] * pz, z);
}

OFFMAP_BY_PROCESSOR void turn(const Rotation& rotation, const TPoint3Df* points, uint32_t count,
                              float* __restrict x, float* __restrict y, float* __restrict range,
                              float* __restrict z) {
    size_t i = 0;
    for (; i + laneCount <= count; i += laneCount) {
        turn<Lanes>(rotation, points + i, x + i, y + i, range + i, z + i);
    }
    for (; i < count; ++i) {
        turn<float>(rotation, points + i, x + i, y + i, range + i, z + i);
    }
}

Rotation uprightFrom(const ScanColumn& column) {
    if (column.sensor) return Rotation(column.sensor->sensorInMap.getRotationMatrix());
    return Rotation(mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix());
}

}  // namespace

void levelColumn(const OrganizedScan& scan, uint32_t column, LevelledScan& levelled) {
    const uint32_t begin = scan.columns[column].begin, end = scan.columns[column].end;
    const uint32_t at = begin - levelled.first;
    turn(uprightFrom(scan.columns[column]), scan.points.data() + begin, end - begin,
         levelled.x.data() + at, levelled.y.data() + at, levelled.range.data() + at,
         levelled.z.data() + at);
}

void level(const OrganizedScan& scan, LevelledScan& levelled) {
    levelled.resize(scan.points.size());
    for (uint32_t c = 0; c < scan.columns.size(); ++c) levelColumn(scan, c, levelled);
}

}  // namespace offmap::core
